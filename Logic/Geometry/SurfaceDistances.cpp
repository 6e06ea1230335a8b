#include "Logic/Geometry/SurfaceDistances.h"

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

VectorXd distancesTo(const Surface& surface, const Points& places) {
  const TriangleTree tree(surface);
  VectorXd distances(places.rows());
  forEachChunk(static_cast<std::size_t>(places.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      distances[i] = tree.closest(places.row(i).transpose()).distance;
  });
  return distances;
}

}  // namespace falciform
