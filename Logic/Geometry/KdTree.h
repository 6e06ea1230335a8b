#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A point of the tree and its squared distance to the query, mm^2. Index -1: none within the bound.
struct Neighbour {
  int index = -1;
  double squaredDistance = std::numeric_limits<double>::infinity();
};

/// Exact nearest neighbours among N points. Ties go to the lowest index, so that answers equal brute force
/// bit for bit (Docs/Decisions/OwnKdTree.md says why it is not FLANN's). Immutable after construction; any
/// number of threads may ask.
class KdTree {
 public:
  KdTree() = default;
  /// Indices returned are rows of `points`.
  explicit KdTree(const Points& points);
  /// A tree over the rows `ids` of `points`; indices returned are rows of `points`.
  KdTree(const Points& points, const std::vector<int>& ids);

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] int size() const { return size_; }

  /// The nearest point with squared distance < `squaredBound`.
  [[nodiscard]] Neighbour nearest(const Vector3d& query,
                                  double squaredBound = std::numeric_limits<double>::infinity()) const;
  /// The nearest point, given one that may be near: `guess.index` a row of the tree's points and
  /// `guess.squaredDistance` its squared distance to `query`. The answer is that of nearest(query), sooner.
  [[nodiscard]] Neighbour nearest(const Vector3d& query, const Neighbour& guess) const;
  /// The k nearest, nearest first (ties by index); fewer if the tree is smaller.
  [[nodiscard]] std::vector<Neighbour> nearest(const Vector3d& query, int k) const;
  /// Every index once; those that follow each other lie near each other. Asking a tree about places in such
  /// an order finds in the cache what the last question left there.
  [[nodiscard]] std::vector<int> inSpaceOrder() const;
  /// All points with distance <= radius, ascending by index.
  [[nodiscard]] std::vector<int> within(const Vector3d& query, double radius) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
  int size_ = 0;
};

/// Squared distance as the tree computes it, so that callers' comparisons agree with its ties.
[[nodiscard]] inline double squaredDistance(const Vector3d& a, const Vector3d& b) {
  const double x = a.x() - b.x(), y = a.y() - b.y(), z = a.z() - b.z();
  return x * x + y * y + z * z;
}

}  // namespace falciform
