#include "Widgets/Rendering/Picking.h"

#include <vtkCamera.h>

#include <cmath>

namespace falciform {

namespace {

Vector3d worldAt(vtkRenderer* renderer, double x, double y, double depth) {
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* w = renderer->GetWorldPoint();
  return Vector3d(w[0], w[1], w[2]) / w[3];
}

std::optional<SurfaceHit> pickCloud(const Surface& cloud, const PickRay& ray, double reachMm) {
  std::optional<SurfaceHit> best;
  double nearest = 0;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Vector3d offset = cloud.points.row(i).transpose() - ray.origin;
    const double along = offset.dot(ray.direction);
    if (along <= 0 || (best && along >= nearest)) continue;
    if ((offset - along * ray.direction).squaredNorm() > reachMm * reachMm) continue;
    nearest = along;
    best = SurfaceHit{-1, static_cast<int>(i), cloud.points.row(i).transpose()};
  }
  return best;
}

}  // namespace

PickRay pickRay(vtkRenderer* renderer, double x, double y) {
  const Vector3d front = worldAt(renderer, x, y, 0), back = worldAt(renderer, x, y, 1);
  return {front, (back - front).normalized()};
}

Eigen::Vector2d screenPosition(vtkRenderer* renderer, const Vector3d& point) {
  renderer->SetWorldPoint(point.x(), point.y(), point.z(), 1);
  renderer->WorldToDisplay();
  const double* at = renderer->GetDisplayPoint();
  return {at[0], at[1]};
}

double mmPerPixel(vtkRenderer* renderer, const Vector3d& point) {
  vtkCamera* camera = renderer->GetActiveCamera();
  Vector3d up;
  camera->GetViewUp(up.data());
  Vector3d forward;
  camera->GetDirectionOfProjection(forward.data());
  const Vector3d side = forward.cross(up).normalized();
  const double pixels = (screenPosition(renderer, point + side) - screenPosition(renderer, point)).norm();
  return pixels > 0 ? 1 / pixels : 1;
}

SurfacePicker::SurfacePicker(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)) {
  if (surface_->triangles.rows() > 0) tree_.emplace(*surface_);
}

std::optional<SurfaceHit> SurfacePicker::pick(const PickRay& ray, double cloudReachMm) const {
  if (!tree_) return pickCloud(*surface_, ray, cloudReachMm);
  const auto hit = tree_->cast(ray.origin, ray.direction);
  if (!hit) return std::nullopt;
  SurfaceHit found{hit->triangle, -1, hit->point};
  double nearest = 0;
  for (int corner = 0; corner < 3; ++corner) {
    const int vertex = tree_->vertexOf(hit->triangle, corner);
    const double distance = (surface_->points.row(vertex).transpose() - hit->point).squaredNorm();
    if (found.vertex < 0 || distance < nearest) {
      found.vertex = vertex;
      nearest = distance;
    }
  }
  return found;
}

}  // namespace falciform
