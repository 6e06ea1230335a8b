#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Types.h"

namespace falciform {

/// A line on the surface in the colour of the patch that is painted: the brush's ring, or the way from click
/// to click.
class BrushCursorPresenter {
 public:
  explicit BrushCursorPresenter(vtkRenderer* renderer);
  ~BrushCursorPresenter();
  BrushCursorPresenter(const BrushCursorPresenter&) = delete;
  BrushCursorPresenter& operator=(const BrushCursorPresenter&) = delete;

  /// N x 3 points of a closed line, mm in the scene.
  void show(const Points& ring, const Vector3d& colour);
  /// N x 3 points of an open line and K x 3 of dots on it.
  void show(const Points& line, const Points& dots, const Vector3d& colour);
  void hide();
  [[nodiscard]] bool visible() const;

 private:
  void draw(const Points& line, bool closed, const Points& dots, const Vector3d& colour);

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> rim_, line_;  ///< a dark, wider line under the coloured one
};

}  // namespace falciform
