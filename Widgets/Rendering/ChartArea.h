#pragma once
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkPlot.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A chart that fills a view and leaves a strip free at its foot for the research notice.
class ChartArea {
 public:
  ChartArea(vtkRenderer* renderer, int textPx, const Vector3d& textColour);
  ~ChartArea();
  ChartArea(const ChartArea&) = delete;
  ChartArea& operator=(const ChartArea&) = delete;

  [[nodiscard]] vtkChartXY* chart() const { return chart_; }
  void setTitle(const std::string& title);
  void setAxisTitle(int axis, const std::string& title);
  /// Fixed ends, with round ticks.
  void setRange(int axisSide, double low, double high);
  /// A line through (x, y) pairs, named in the legend unless `name` is empty; `right`: against the axis on
  /// the right.
  vtkPlot* addLine(const std::string& name, const std::vector<std::pair<double, double>>& points,
                   const Vector3d& colour, double widthPx, bool right = false);

 private:
  void fit();

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkContextActor> actor_;
  vtkSmartPointer<vtkChartXY> chart_;
  int textPx_;
  unsigned long observer_ = 0;
};

}  // namespace falciform
