#include "Widgets/Rendering/BrushRing.h"

#include <cmath>
#include <numbers>

namespace falciform {

Points flatRing(const Vector3d& centre, const Vector3d& viewDirection, double radiusMm, int count) {
  const Vector3d u = viewDirection.unitOrthogonal(), v = viewDirection.normalized().cross(u);
  Points ring(count, 3);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    ring.row(i) = (centre + radiusMm * (std::cos(angle) * u + std::sin(angle) * v)).transpose();
  }
  return ring;
}

Points geodesicRing(const TriangleTree& tree, int triangle, const Vector3d& centre, double radiusMm,
                    int count) {
  constexpr int kSteps = 8;
  const Vector3d normal = tree.triangleNormal(triangle);
  Points ring = flatRing(Vector3d::Zero(), normal, 1, count);
  for (int i = 0; i < count; ++i) {
    Vector3d at = centre, heading = ring.row(i).transpose();
    for (int step = 0; step < kSteps; ++step) {
      const ClosestPlace place = tree.closestAnySide(at + radiusMm / kSteps * heading);
      at = place.point;
      // Straight on: the heading loses only its part across the surface.
      const Vector3d n = tree.triangleNormal(place.triangle);
      const Vector3d flat = heading - heading.dot(n) * n;
      if (flat.norm() > 1e-9) heading = flat.normalized();
    }
    ring.row(i) = at.transpose();
  }
  return ring;
}

}  // namespace falciform
