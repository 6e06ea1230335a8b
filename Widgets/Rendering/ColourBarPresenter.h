#pragma once
#include <vtkProp.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "Widgets/Rendering/ScalarMap.h"

namespace falciform {

/// The scale of a ScalarMap at the right of the view: title and unit, round values, and the greys for "no
/// value" and "off the scale".
class ColourBarPresenter {
 public:
  ColourBarPresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour);
  ~ColourBarPresenter();
  ColourBarPresenter(const ColourBarPresenter&) = delete;
  ColourBarPresenter& operator=(const ColourBarPresenter&) = delete;

  /// `swatches`: with the colours of no value and of values off the scale.
  void show(const ScalarMap& map, bool swatches = true);
  void clear();

 private:
  void keep(vtkSmartPointer<vtkProp> part);

  vtkSmartPointer<vtkRenderer> renderer_;
  int textPx_;
  Vector3d textColour_;
  std::vector<vtkSmartPointer<vtkProp>> parts_;
};

}  // namespace falciform
