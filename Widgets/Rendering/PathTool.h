#pragma once
#include <optional>
#include <vector>

#include "Logic/Patches/PatchPaintingLogic.h"
#include "Widgets/Rendering/BrushCursorPresenter.h"

namespace falciform {

/// The line that is laid over the surface from click to click, drawn as it grows; what it paints is for the
/// caller.
class PathTool {
 public:
  explicit PathTool(vtkRenderer* renderer) : drawing_(renderer) {}

  [[nodiscard]] bool empty() const { return clicks_.empty(); }
  /// The way from the last click to `place` becomes part of the line. False, and nothing happens, where there
  /// is none.
  bool click(const BrushSurface& surface, const TriangleTree* tree, const SurfacePlace& place,
             const VectorXd& cost);
  /// The way to where the mouse is now, until the next one.
  void hover(const BrushSurface& surface, const TriangleTree* tree, const SurfacePlace& place,
             const VectorXd& cost);
  /// Takes the last click back.
  void back();
  void clear();
  /// All ways so far, one after the other.
  [[nodiscard]] std::vector<SurfacePlace> line() const;

  void draw(const Isometry3d& sceneFromSurface, const Vector3d& colour);

 private:
  BrushCursorPresenter drawing_;
  std::vector<SurfacePlace> clicks_;
  std::vector<std::vector<SurfacePlace>> ways_;  ///< one fewer than clicks
  std::vector<SurfacePlace> ahead_;              ///< to the mouse
};

}  // namespace falciform
