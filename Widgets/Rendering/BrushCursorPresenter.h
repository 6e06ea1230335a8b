#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Types.h"

namespace falciform {

/// The brush's ring on the surface, in the colour of the patch that is painted.
class BrushCursorPresenter {
 public:
  explicit BrushCursorPresenter(vtkRenderer* renderer);
  ~BrushCursorPresenter();
  BrushCursorPresenter(const BrushCursorPresenter&) = delete;
  BrushCursorPresenter& operator=(const BrushCursorPresenter&) = delete;

  /// N x 3 points of a closed line, mm in the scene.
  void show(const Points& ring, const Vector3d& colour);
  void hide();
  [[nodiscard]] bool visible() const;

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> rim_, line_;  ///< a dark, wider line under the coloured one
};

}  // namespace falciform
