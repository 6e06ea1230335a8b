#pragma once
#include <array>
#include <limits>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A bounding-volume hierarchy with four children a node, over items given by their boxes; built by the
/// surface-area heuristic. Boxes are single precision about the centre of all items, widened so that rounding
/// never hides an item.
class BoxTree {
 public:
  /// Lowest and highest corner of item i in row i; the matrices have the same number of rows, at least 1.
  BoxTree(const Points& low, const Points& high);

  /// Items in the order of the leaves: a leaf is a run of this list.
  [[nodiscard]] const std::vector<int>& order() const { return order_; }

  /// Calls `leaf(begin, end)` (a run of order()) for leaves that may hold something within `squaredBound` of
  /// `query`, nearer boxes first; `leaf` may lower `squaredBound`.
  template <class Leaf>
  void visitNear(const Vector3d& query, const double& squaredBound, Leaf&& leaf) const;

  /// The same along a ray with unit direction; `distanceBound` (mm from `origin`) may be lowered.
  template <class Leaf>
  void visitAlong(const Vector3d& origin, const Vector3d& direction, const double& distanceBound,
                  Leaf&& leaf) const;

 private:
  static constexpr int kWidth = 4, kLeafItems = 8, kStack = 256;
  using Four = Eigen::Array4f;

  struct Node {
    std::array<Four, 3> low, high;             ///< per axis, one lane a child
    std::array<int, kWidth> child{};           ///< a node, or for a leaf the start of its run
    std::array<std::uint8_t, kWidth> items{};  ///< number of items of a leaf, 0 for a node
    int children = 0;
  };
  struct Visit {
    float key;
    int child, items;
  };
  struct Builder;

  template <class Keys, class Bound, class Leaf>
  void walk(const Keys& keys, const Bound& bound, Leaf&& leaf) const;

  std::vector<Node> nodes_;
  std::vector<int> order_;
  Vector3d centre_ = Vector3d::Zero();
  double radius_ = 0;  ///< of a sphere about the centre that holds all boxes, mm
};

template <class Keys, class Bound, class Leaf>
void BoxTree::walk(const Keys& keys, const Bound& bound, Leaf&& leaf) const {
  std::array<Visit, kStack> stack;
  int top = 0;
  stack[top++] = {0, 0, 0};
  while (top > 0) {
    const Visit visit = stack[--top];
    float limit = bound();
    if (visit.key > limit) continue;
    if (visit.items > 0) {
      leaf(visit.child, visit.child + visit.items);
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(visit.child)];
    const Four key = keys(node);
    const int first = top;
    for (int i = 0; i < node.children; ++i) {
      if (!(key[i] <= limit)) continue;
      const auto lane = static_cast<std::size_t>(i);
      int at = top++;  // farthest first, so that the nearest is on top
      for (; at > first && stack[static_cast<std::size_t>(at) - 1].key < key[i]; --at)
        stack[static_cast<std::size_t>(at)] = stack[static_cast<std::size_t>(at) - 1];
      stack[static_cast<std::size_t>(at)] = {key[i], node.child[lane], node.items[lane]};
    }
  }
}

template <class Leaf>
void BoxTree::visitNear(const Vector3d& query, const double& squaredBound, Leaf&& leaf) const {
  const Eigen::Vector3f q = (query - centre_).cast<float>();
  const auto keys = [&](const Node& node) {
    Four sum = Four::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float at = q[static_cast<Index>(axis)];
      const Four gap = (node.low[axis] - at).max(at - node.high[axis]).max(0.0F);
      sum += gap * gap;
    }
    return sum;
  };
  // 1e-5: far above the relative rounding of four float operations.
  walk(
      keys, [&] { return static_cast<float>(squaredBound) * 1.00001F; }, leaf);
}

template <class Leaf>
void BoxTree::visitAlong(const Vector3d& origin, const Vector3d& direction, const double& distanceBound,
                         Leaf&& leaf) const {
  // The ray starts anew where it enters the sphere about everything, so that floats carry it from any
  // distance.
  const double toCentre = (centre_ - origin).dot(direction);
  const double aside2 = (origin + toCentre * direction - centre_).squaredNorm();
  if (!(aside2 <= radius_ * radius_ * 1.000001) || toCentre < -radius_) return;
  const double skipped = std::max(0.0, toCentre - radius_);
  const Eigen::Vector3f start = (origin + skipped * direction - centre_).cast<float>();
  Eigen::Vector3f inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const auto d = static_cast<float>(direction[axis]);
    inverse[axis] = 1.0F / (std::abs(d) > 1e-20F ? d : std::copysign(1e-20F, d));  // no 0 * infinity below
  }
  const auto keys = [&](const Node& node) {
    Four enter = Four::Zero(), leave = Four::Constant(std::numeric_limits<float>::infinity());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Index>(axis);
      const Four one = (node.low[axis] - start[a]) * inverse[a],
                 other = (node.high[axis] - start[a]) * inverse[a];
      enter = enter.max(one.min(other));
      leave = leave.min(one.max(other));
    }
    return Four((enter * 0.99999F <= leave * 1.00001F)
                    .select(enter * 0.99999F, Four::Constant(std::numeric_limits<float>::infinity())));
  };
  const auto slack = static_cast<float>(1e-5 * radius_);
  walk(
      keys,
      [&] {
        const double left = distanceBound - skipped;
        return left < 1e30 ? static_cast<float>(left) * 1.00001F + slack : 1e30F;
      },
      leaf);
}

}  // namespace falciform
