#include "Logic/Deformation/Normalisation/SurfaceErrors.h"

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

VectorXd distancesTo(const Surface& surface, const Points& places) {
  const TriangleTree tree(surface);
  VectorXd distances(places.rows());
  forEachChunk(static_cast<std::size_t>(places.rows()), 512, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      distances[i] = tree.closest(places.row(i).transpose()).distance;
  });
  return distances;
}

}  // namespace

SurfaceErrors surfaceErrors(const Surface& target, const Surface& source, const LiverMap& map) {
  SurfaceErrors errors;
  errors.moved = source;
  errors.moved.points = map.toTarget(source.points);
  errors.moved.normals.resize(0, 3);
  errors.sourceToTarget = distancesTo(target, errors.moved.points);
  errors.targetToSource = distancesTo(errors.moved, target.points);
  return errors;
}

}  // namespace falciform
