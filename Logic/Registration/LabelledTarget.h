#pragma once
#include <map>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

/// The target of a registration, ready for the label-biased closest point of Eq. (III.1): one tree over all
/// points and one over each label in use. Immutable; any number of threads may ask.
class LabelledTarget {
 public:
  /// `labels` > 0: those in use; a point of any other label counts as label 0. `surface` is copied as far as
  /// needed.
  LabelledTarget(const Surface& surface, const std::vector<int>& labels);

  [[nodiscard]] const Points& points() const { return points_; }
  [[nodiscard]] int labelOf(int point) const { return labels_[static_cast<std::size_t>(point)]; }
  [[nodiscard]] bool has(int label) const { return trees_.contains(label); }

  /// The point that minimises d = w_PC |s - t| where labels agree (both > 0), |s - t| otherwise: exactly,
  /// ties to the lowest index. `weight` is w_PC in (0, 1]. The distance returned is the real one. `guess` -1
  /// or a point that may be near.
  [[nodiscard]] Neighbour closest(const Vector3d& query, int label, double weight, int guess = -1) const;
  /// The nearest point of `label`, which must be in use. `guess` -1 or a point of that label that may be
  /// near.
  [[nodiscard]] Neighbour closestOfLabel(const Vector3d& query, int label, int guess = -1) const;

 private:
  [[nodiscard]] Neighbour at(int point, const Vector3d& query) const {
    return {point, squaredDistance(query, points_.row(point).transpose())};
  }

  Points points_;
  std::vector<int> labels_;
  KdTree all_;
  std::map<int, KdTree> trees_;
};

}  // namespace falciform
