#pragma once
#include "Logic/Core/Results.h"
#include "Widgets/Rendering/ChartArea.h"

namespace falciform {

/// The signed distances of both sides of a distance map as two stepped curves, with mean, SD and 95 % in the
/// title.
class HistogramPresenter {
 public:
  HistogramPresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour);

  void show(const DistanceMap& map);

 private:
  ChartArea area_;
  double lineWidthPx_;
};

}  // namespace falciform
