#pragma once
#include <vtkActor2D.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "Logic/Patches/Lasso.h"

namespace falciform {

/// The line that is drawn on the screen around what is to be painted.
class LassoTool {
 public:
  explicit LassoTool(vtkRenderer* renderer);
  ~LassoTool();
  LassoTool(const LassoTool&) = delete;
  LassoTool& operator=(const LassoTool&) = delete;

  [[nodiscard]] bool running() const { return !corners_.empty(); }
  /// Pixels from the bottom left, as VTK's events.
  void add(int x, int y);
  void clear();
  /// Points of the surface inside the line as the renderer shows it now, drawn at `sceneFromSurface`.
  [[nodiscard]] std::vector<int> inside(const Surface& surface, const TriangleTree* tree,
                                        const Isometry3d& sceneFromSurface) const;

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkActor2D> rim_, line_;
  std::vector<Eigen::Vector2d> corners_;
};

}  // namespace falciform
