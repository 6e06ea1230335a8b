#include "Logic/Geometry/KdTree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr int kLeafSize = 8;
constexpr int kForkSize = 2048, kForks = 2;  // smaller parts are not worth a thread

/// A node's box is cut at `lower` (where its left half ends) and `upper` (where its right half begins) along
/// `axis`. A leaf has axis -1; `left` is its place among the leaves.
struct Node {
  double lower = 0, upper = 0;
  int left = 0, right = 0;
  int axis = -1;
};

struct Entry {
  Vector3d at;
  int index = 0;
};

bool nearer(double squared, int index, const Neighbour& than) {
  return squared < than.squaredDistance || (squared == than.squaredDistance && index < than.index);
}

/// Its points' coordinates side by side, so that all distances are formed at once; places beyond `count` are
/// infinitely far.
struct Leaf {
  using Row = Eigen::Array<double, kLeafSize, 1>;
  Row x, y, z;
  std::array<int, kLeafSize> index{};
  int count = 0;
  /// As squaredDistance forms them.
  [[nodiscard]] Row squaredDistances(const Vector3d& query) const {
    return (query.x() - x).square() + (query.y() - y).square() + (query.z() - z).square();
  }
  void improve(const Vector3d& query, Neighbour& best) const {
    const Row squared = squaredDistances(query);
    if (squared.minCoeff() > best.squaredDistance) return;
    for (int i = 0; i < count; ++i) {
      const int id = index[static_cast<std::size_t>(i)];
      if (nearer(squared[i], id, best)) best = {id, squared[i]};
    }
  }
};

Leaf leafOf(const Entry* begin, const Entry* end) {
  Leaf leaf;
  leaf.x = leaf.y = leaf.z = Leaf::Row::Constant(std::numeric_limits<double>::infinity());
  for (; begin != end; ++begin, ++leaf.count) {
    leaf.x[leaf.count] = begin->at.x();
    leaf.y[leaf.count] = begin->at.y();
    leaf.z[leaf.count] = begin->at.z();
    leaf.index[static_cast<std::size_t>(leaf.count)] = begin->index;
  }
  return leaf;
}

}  // namespace

struct KdTree::Tree {
  using Box = Eigen::AlignedBox3d;
  std::vector<Entry> entries;  // while it is built; a leaf's node then names its range by `left` and `right`
  std::vector<Node> nodes;
  std::vector<Leaf> leaves;
  Box box;

  [[nodiscard]] Box boxOf(int begin, int end) const {
    Box around;
    for (int i = begin; i < end; ++i) around.extend(entries[static_cast<std::size_t>(i)].at);
    return around;
  }

  /// Sorts the entries [begin, end) into halves along the box's longest side, which it returns: the left
  /// half, up to `middle`, is one of whole leaves.
  int cut(int begin, int end, const Box& around, int& middle) {
    Index axis = 0;
    around.sizes().maxCoeff(&axis);
    const int wanted = (end - begin + kLeafSize - 1) / kLeafSize;
    middle = begin + (wanted + 1) / 2 * kLeafSize;
    std::nth_element(entries.begin() + begin, entries.begin() + middle, entries.begin() + end,
                     [axis](const Entry& a, const Entry& b) { return a.at[axis] < b.at[axis]; });
    return static_cast<int>(axis);
  }

  /// Appends the nodes over [begin, end), parents first; returns their box.
  Box append(std::vector<Node>& built, int begin, int end) {
    const std::size_t id = built.size();
    built.push_back({.left = begin, .right = end, .axis = -1});
    const Box around = boxOf(begin, end);
    if (end - begin <= kLeafSize) return around;
    Node node;
    int middle = 0;
    node.axis = cut(begin, end, around, middle);
    node.left = static_cast<int>(built.size());
    node.lower = append(built, begin, middle).max()[node.axis];
    node.right = static_cast<int>(built.size());
    node.upper = append(built, middle, end).min()[node.axis];
    built[id] = node;
    return around;
  }

  /// Nodes over a range, parents first, children numbered from the first of these.
  struct Part {
    std::vector<Node> nodes;
    Box box;
  };

  /// The halves of the upper `forks` levels are built beside each other: the tree is the same either way.
  Part build(int begin, int end, int forks) {
    Part part;
    if (forks == 0 || end - begin <= kForkSize) {
      part.box = append(part.nodes, begin, end);
      return part;
    }
    part.box = boxOf(begin, end);
    int middle = 0;
    Node root;
    root.axis = cut(begin, end, part.box, middle);
    Part left, right;
    forEachChunk(2, 1, [&](std::size_t h, std::size_t) {
      (h == 0 ? left : right) = h == 0 ? build(begin, middle, forks - 1) : build(middle, end, forks - 1);
    });
    root.lower = left.box.max()[root.axis];
    root.upper = right.box.min()[root.axis];
    root.left = 1;
    root.right = 1 + static_cast<int>(left.nodes.size());
    part.nodes.push_back(root);
    for (const auto& [half, first] : {std::pair(&left, root.left), std::pair(&right, root.right)})
      for (Node node : half->nodes) {
        if (node.axis >= 0) node.left += first, node.right += first;
        part.nodes.push_back(node);
      }
    return part;
  }

  void plant() {
    Part whole = build(0, static_cast<int>(entries.size()), kForks);
    nodes = std::move(whole.nodes);
    box = whole.box;
    std::vector<int> ends;
    for (int id = 0; id < static_cast<int>(nodes.size()); ++id)
      if (nodes[static_cast<std::size_t>(id)].axis < 0) ends.push_back(id);
    leaves.resize(ends.size());
    forEachChunk(ends.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        Node& node = nodes[static_cast<std::size_t>(ends[k])];
        leaves[k] = leafOf(entries.data() + node.left, entries.data() + node.right);
        node.left = static_cast<int>(k);
      }
    });
    entries = {};
  }

  /// Visits leaves that may hold a point with squared distance <= `bound()`, near side first. `gaps` are the
  /// squared distances from the query to the node's box along each axis. Their sum is formed anew in the
  /// order that squaredDistance uses, so that rounding can never make a box seem farther than a point in it.
  template <class Bound, class Visit>
  void visit(int id, const std::array<double, 3>& query, std::array<double, 3> gaps, const Bound& bound,
             const Visit& leaf) const {
    const Node* node = &nodes[static_cast<std::size_t>(id)];
    while (node->axis >= 0) {
      const auto axis = static_cast<std::size_t>(node->axis);
      const double toLower = query[axis] - node->lower, toUpper = query[axis] - node->upper;
      const bool leftFirst = toLower + toUpper < 0;
      std::array<double, 3> farGaps = gaps;
      const double gap = leftFirst ? toUpper : toLower;
      // The far half may still contain the query's coordinate when halves meet; then its gap is what it was.
      const bool apart = leftFirst ? gap < 0 : gap > 0;
      if (apart) farGaps[axis] = std::max(gaps[axis], gap * gap);
      const int nearId = leftFirst ? node->left : node->right, farId = leftFirst ? node->right : node->left;
      visit(nearId, query, gaps, bound, leaf);
      if (farGaps[0] + farGaps[1] + farGaps[2] > bound()) return;
      gaps = farGaps;
      node = &nodes[static_cast<std::size_t>(farId)];
    }
    leaf(leaves[static_cast<std::size_t>(node->left)]);
  }

  template <class Bound, class Visit>
  void search(const Vector3d& q, const Bound& bound, const Visit& leaf) const {
    const std::array<double, 3> query{q.x(), q.y(), q.z()};
    std::array<double, 3> gaps{};
    for (int a = 0; a < 3; ++a) {
      const double gap = std::max({box.min()[a] - q[a], q[a] - box.max()[a], 0.0});
      gaps[static_cast<std::size_t>(a)] = gap * gap;
    }
    if (gaps[0] + gaps[1] + gaps[2] <= bound()) visit(0, query, gaps, bound, leaf);
  }

  void improve(const Vector3d& query, Neighbour& best) const {
    search(
        query, [&] { return best.squaredDistance; }, [&](const Leaf& leaf) { leaf.improve(query, best); });
  }
};

KdTree::KdTree(const Points& points, const std::vector<int>& ids) : size_(static_cast<int>(ids.size())) {
  if (ids.empty()) return;
  auto tree = std::make_shared<Tree>();
  tree->entries.reserve(ids.size());
  for (const int i : ids) tree->entries.push_back({points.row(i).transpose(), i});
  tree->plant();
  tree_ = std::move(tree);
}

KdTree::KdTree(const Points& points)
    : KdTree(points, [&] {
        std::vector<int> all(static_cast<std::size_t>(points.rows()));
        std::iota(all.begin(), all.end(), 0);
        return all;
      }()) {}

Neighbour KdTree::nearest(const Vector3d& query, double squaredBound) const {
  // Index -1 loses no tie to a point at the bound itself: the bound is exclusive.
  Neighbour best{-1, squaredBound};
  if (tree_) tree_->improve(query, best);
  return best.index < 0 ? Neighbour{} : best;
}

Neighbour KdTree::nearest(const Vector3d& query, const Neighbour& guess) const {
  Neighbour best = guess;
  if (tree_) tree_->improve(query, best);
  return best;
}

std::vector<Neighbour> KdTree::nearest(const Vector3d& query, int k) const {
  std::vector<Neighbour> found;  // nearest first
  if (!tree_ || k <= 0) return found;
  const auto wanted = static_cast<std::size_t>(std::min(k, size_));
  found.reserve(wanted);
  double farthest = std::numeric_limits<double>::infinity();  // once all that are wanted are there
  tree_->search(
      query, [&] { return farthest; },
      [&](const Leaf& leaf) {
        const Leaf::Row squared = leaf.squaredDistances(query);
        for (int i = 0; i < leaf.count; ++i) {
          const Neighbour next{leaf.index[static_cast<std::size_t>(i)], squared[i]};
          if (found.size() == wanted) {
            if (!nearer(next.squaredDistance, next.index, found.back())) continue;
            found.pop_back();
          }
          auto place = found.end();
          while (place != found.begin() && nearer(next.squaredDistance, next.index, *(place - 1))) --place;
          found.insert(place, next);
          if (found.size() == wanted) farthest = found.back().squaredDistance;
        }
      });
  return found;
}

std::vector<int> KdTree::inSpaceOrder() const {
  std::vector<int> ids;
  ids.reserve(static_cast<std::size_t>(size_));
  if (tree_)
    for (const Leaf& leaf : tree_->leaves)
      ids.insert(ids.end(), leaf.index.begin(), leaf.index.begin() + leaf.count);
  return ids;
}

std::vector<int> KdTree::within(const Vector3d& query, double radius) const {
  std::vector<int> found;
  if (!tree_ || !(radius >= 0)) return found;
  const double bound = radius * radius;
  tree_->search(
      query, [&] { return bound; },
      [&](const Leaf& leaf) {
        const Leaf::Row squared = leaf.squaredDistances(query);
        for (int i = 0; i < leaf.count; ++i)
          if (squared[i] <= bound) found.push_back(leaf.index[static_cast<std::size_t>(i)]);
      });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace falciform
