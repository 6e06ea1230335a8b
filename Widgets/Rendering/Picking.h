#pragma once
#include <vtkRenderer.h>

#include <memory>
#include <optional>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

struct PickRay {
  Vector3d origin = Vector3d::Zero();
  Vector3d direction = Vector3d::UnitZ();  ///< unit, away from the viewer
};

/// The line of sight through a pixel (origin bottom left, as VTK's events), in the scene's frame. The
/// renderer must be in a window.
[[nodiscard]] PickRay pickRay(vtkRenderer* renderer, double x, double y);

/// Where a point of the scene is drawn, in pixels from the bottom left.
[[nodiscard]] Eigen::Vector2d screenPosition(vtkRenderer* renderer, const Vector3d& point);

/// Length in the scene, mm, of one pixel at the depth of `point`.
[[nodiscard]] double mmPerPixel(vtkRenderer* renderer, const Vector3d& point);

struct SurfaceHit {
  int triangle = -1;  ///< -1 on a cloud
  int vertex = -1;    ///< the nearest vertex
  Vector3d point = Vector3d::Zero();
};

/// Answers what lies under the mouse on one surface or cloud. Keeps its own search tree; exact, and quick
/// enough for each mouse move.
class SurfacePicker {
 public:
  explicit SurfacePicker(std::shared_ptr<const Surface> surface);

  /// The first place that the ray meets. On a cloud: of the points within `cloudReachMm` of the ray, the one
  /// nearest to the viewer.
  [[nodiscard]] std::optional<SurfaceHit> pick(const PickRay& ray, double cloudReachMm = 2) const;

  [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return surface_; }
  /// None for a cloud.
  [[nodiscard]] const TriangleTree* tree() const { return tree_ ? &*tree_ : nullptr; }

 private:
  std::shared_ptr<const Surface> surface_;
  std::optional<TriangleTree> tree_;
};

}  // namespace falciform
