#include "Logic/Registration/LabelledTarget.h"

#include <cmath>
#include <limits>

namespace falciform {

LabelledTarget::LabelledTarget(const Surface& surface, const std::vector<int>& labels)
    : points_(surface.points), labels_(static_cast<std::size_t>(surface.size()), 0), all_(points_) {
  for (const int label : labels) {
    const std::vector<int> ids = pointsOfPatch(surface, label);
    if (label <= 0 || ids.empty()) continue;
    trees_.emplace(label, KdTree(points_, ids));
    for (const int i : ids) labels_[static_cast<std::size_t>(i)] = label;
  }
}

Neighbour LabelledTarget::closestOfLabel(const Vector3d& query, int label, int guess) const {
  const KdTree& tree = trees_.at(label);
  return guess < 0 ? tree.nearest(query) : tree.nearest(query, at(guess, query));
}

Neighbour LabelledTarget::closest(const Vector3d& query, int label, double weight, int guess) const {
  const auto tree = label > 0 ? trees_.find(label) : trees_.end();
  if (tree == trees_.end()) return guess < 0 ? all_.nearest(query) : all_.nearest(query, at(guess, query));

  const Neighbour own = guess >= 0 && labelOf(guess) == label ? tree->second.nearest(query, at(guess, query))
                                                              : tree->second.nearest(query);
  // Eq. (III.1): another point wins only if |s - t| < w_PC d_L. Within that radius no point has label L (none
  // is nearer than d_L), so the global neighbour, if there is one, is the minimum. At equality the lower
  // index wins.
  const double scaled = weight * weight * own.squaredDistance;
  const Neighbour other =
      all_.nearest(query, std::nextafter(scaled, std::numeric_limits<double>::infinity()));
  if (other.index < 0 || labelOf(other.index) == label) return own;
  if (other.squaredDistance < scaled || other.index < own.index) return other;
  return own;
}

}  // namespace falciform
