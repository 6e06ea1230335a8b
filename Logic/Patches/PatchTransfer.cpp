#include "Logic/Patches/PatchTransfer.h"

#include <cmath>
#include <limits>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

std::vector<int> transferPatches(const Surface& from, const Surface& to, double radiusMm, bool keepOld) {
  std::vector<int> labels(static_cast<std::size_t>(to.size()), patch::kNone);
  if (keepOld && !to.patch.empty()) labels = to.patch;

  std::vector<int> painted;
  for (Index i = 0; i < from.size(); ++i)
    if (from.patchAt(i) != patch::kNone) painted.push_back(static_cast<int>(i));
  if (painted.empty() || !(radiusMm >= 0)) return labels;

  const KdTree tree(from.points, painted);
  // The tree's bound is open, the radius closed.
  const double bound = std::nextafter(radiusMm * radiusMm, std::numeric_limits<double>::infinity());
  forEachChunk(labels.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Neighbour nearest = tree.nearest(to.points.row(static_cast<Index>(i)).transpose(), bound);
      if (nearest.index >= 0) labels[i] = from.patchAt(nearest.index);
    }
  });
  return labels;
}

}  // namespace falciform
