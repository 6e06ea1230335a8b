#pragma once
#include <vtkProp.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

struct LegendEntry {
  Vector3d colour;  ///< red, green, blue in [0, 1]
  std::string text;
};

/// Coloured squares with their meaning, one a line, at the upper left of the view.
class LegendPresenter {
 public:
  LegendPresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour);
  ~LegendPresenter();
  LegendPresenter(const LegendPresenter&) = delete;
  LegendPresenter& operator=(const LegendPresenter&) = delete;

  void show(const std::vector<LegendEntry>& entries);

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  int textPx_;
  Vector3d textColour_;
  std::vector<vtkSmartPointer<vtkProp>> parts_;
};

}  // namespace falciform
