#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A point of the tree and its squared distance to the query, mm^2. index -1: none within the bound.
struct Neighbour {
  int index = -1;
  double squaredDistance = std::numeric_limits<double>::infinity();
};

/// Exact nearest neighbours among N points. Ties go to the lowest index, so that answers equal brute force bit for bit.
/// Immutable after construction; any number of threads may ask.
class KdTree {
 public:
  KdTree() = default;
  /// Indices returned are rows of `points`.
  explicit KdTree(const Points& points);
  /// A tree over the rows `ids` of `points`; indices returned are rows of `points`.
  KdTree(const Points& points, const std::vector<int>& ids);

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] int size() const { return size_; }

  /// The nearest point with squared distance < `squaredBound` (or == it at a lower index than `notBefore`).
  [[nodiscard]] Neighbour nearest(const Vector3d& query,
                                  double squaredBound = std::numeric_limits<double>::infinity()) const;
  /// The k nearest, nearest first (ties by index); fewer if the tree is smaller.
  [[nodiscard]] std::vector<Neighbour> nearest(const Vector3d& query, int k) const;
  /// All points with distance <= radius, ascending by index.
  [[nodiscard]] std::vector<int> within(const Vector3d& query, double radius) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
  int size_ = 0;
};

}  // namespace falciform
