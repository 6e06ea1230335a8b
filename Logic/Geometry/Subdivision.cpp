#include "Logic/Geometry/Subdivision.h"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

Surface subdivided(const Surface& surface) {
  std::unordered_map<std::uint64_t, int> middles;
  std::vector<std::pair<int, int>> ends;
  const auto middle = [&](int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const std::uint64_t key = static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
    const auto [at, fresh] =
        middles.try_emplace(key, static_cast<int>(surface.size()) + static_cast<int>(ends.size()));
    if (fresh) ends.emplace_back(low, high);
    return at->second;
  };
  Surface fine;
  fine.frame = surface.frame;
  fine.patchNames = surface.patchNames;
  fine.triangles.resize(4 * surface.triangles.rows(), 3);
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const int a = surface.triangles(t, 0), b = surface.triangles(t, 1), c = surface.triangles(t, 2);
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.middleRows<4>(4 * t) << a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca;
  }
  const Index old = surface.size();
  fine.points.resize(old + static_cast<Index>(ends.size()), 3);
  fine.points.topRows(old) = surface.points;
  if (!surface.patch.empty()) fine.patch = surface.patch;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const auto [a, b] = ends[k];
    fine.points.row(old + static_cast<Index>(k)) = (surface.points.row(a) + surface.points.row(b)) / 2;
    if (!surface.patch.empty())
      fine.patch.push_back(surface.patchAt(a) == surface.patchAt(b) ? surface.patchAt(a) : patch::kNone);
  }
  return fine;
}

Surface subdividedTo(const Surface& surface, double edgeLengthMm) {
  if (!(edgeLengthMm > 0))
    throw InputError("the edge length to subdivide to is " + std::to_string(edgeLengthMm) +
                     " mm; give more than 0");
  Surface fine = surface;
  while (fine.triangles.rows() > 0 && meanEdgeLength(fine) > edgeLengthMm) {
    if (fine.triangles.rows() > 5'000'000)
      throw InputError("edges of " + std::to_string(edgeLengthMm) +
                       " mm would make more than 20 million triangles; take longer ones");
    fine = subdivided(fine);
  }
  return fine;
}

}  // namespace falciform
