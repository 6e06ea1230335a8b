#include "Logic/Geometry/PlaneSection.h"

#include <array>
#include <vector>

namespace falciform {
namespace {

/// From the lower end to the higher, so that both triangles of an edge find the same place, bit for bit.
Vector3d crossing(const Surface& surface, int axis, double value, int a, int b) {
  if (surface.points(a, axis) > surface.points(b, axis)) std::swap(a, b);
  const Vector3d low = surface.points.row(a).transpose(), high = surface.points.row(b).transpose();
  return low + (value - low[axis]) / (high[axis] - low[axis]) * (high - low);
}

}  // namespace

Points planeSection(const Surface& surface, int axis, double valueMm) {
  std::vector<Vector3d> ends;
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    std::array<bool, 3> above{};
    for (Index k = 0; k < 3; ++k)
      above[static_cast<std::size_t>(k)] = surface.points(surface.triangles(t, k), axis) >= valueMm;
    if (above[0] == above[1] && above[1] == above[2]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (above[k] != above[next])
        ends.push_back(crossing(surface, axis, valueMm, surface.triangles(t, static_cast<Index>(k)),
                                surface.triangles(t, static_cast<Index>(next))));
    }
  }
  Points section(static_cast<Index>(ends.size()), 3);
  for (Index i = 0; i < section.rows(); ++i) section.row(i) = ends[static_cast<std::size_t>(i)].transpose();
  return section;
}

}  // namespace falciform
