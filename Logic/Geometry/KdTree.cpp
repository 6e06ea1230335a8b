#include "Logic/Geometry/KdTree.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr int kLeafSize = 8;
constexpr int kForkSize = 2048, kForks = 2;  // smaller parts are not worth a thread

/// A node's box is cut at `lower` (where its left half ends) and `upper` (where its right half begins) along
/// `axis`. A leaf has axis -1 and holds the entries [left, right).
struct Node {
  double lower = 0, upper = 0;
  int left = 0, right = 0;
  int axis = -1;
};

struct Entry {
  double x = 0, y = 0, z = 0;
  int index = 0;
};

double coordinate(const Entry& entry, int axis) {
  return axis == 0 ? entry.x : axis == 1 ? entry.y : entry.z;
}

bool nearer(double squared, int index, const Neighbour& than) {
  return squared < than.squaredDistance || (squared == than.squaredDistance && index < than.index);
}

}  // namespace

struct KdTree::Tree {
  std::vector<Entry> entries;
  std::vector<Node> nodes;
  std::array<double, 3> lowest{}, highest{};

  /// Sorts the entries [begin, end) into halves; a leaf stays whole. Returns where the right half begins.
  int split(int begin, int end, Node& node) {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (int i = begin; i < end; ++i)
      for (std::size_t a = 0; a < 3; ++a) {
        const double c = coordinate(entries[static_cast<std::size_t>(i)], static_cast<int>(a));
        low[a] = std::min(low[a], c);
        high[a] = std::max(high[a], c);
      }
    if (begin == 0 && end == static_cast<int>(entries.size())) lowest = low, highest = high;
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (high[static_cast<std::size_t>(a)] - low[static_cast<std::size_t>(a)] >
          high[static_cast<std::size_t>(axis)] - low[static_cast<std::size_t>(axis)])
        axis = a;
    const auto first = entries.begin() + begin, last = entries.begin() + end;
    if (end - begin <= kLeafSize) {
      std::sort(first, last, [](const Entry& a, const Entry& b) { return a.index < b.index; });
      node = {.left = begin, .right = end, .axis = -1};
      return end;
    }
    const int middle = begin + (end - begin) / 2;
    const auto before = [axis](const Entry& a, const Entry& b) {
      const double ca = coordinate(a, axis), cb = coordinate(b, axis);
      return ca < cb || (ca == cb && a.index < b.index);
    };
    std::nth_element(first, entries.begin() + middle, last, before);
    node.axis = axis;
    node.upper = coordinate(entries[static_cast<std::size_t>(middle)], axis);
    node.lower = coordinate(*std::max_element(first, entries.begin() + middle, before), axis);
    return middle;
  }

  /// Appends the nodes over [begin, end), parents first.
  int append(std::vector<Node>& built, int begin, int end) {
    const int id = static_cast<int>(built.size());
    built.emplace_back();
    Node node;
    const int middle = split(begin, end, node);
    if (node.axis >= 0) {
      node.left = append(built, begin, middle);
      node.right = append(built, middle, end);
    }
    built[static_cast<std::size_t>(id)] = node;
    return id;
  }

  /// The nodes over [begin, end), parents first, children numbered from the first of these. The halves of the
  /// upper `forks` levels are built beside each other: the tree is the same either way.
  std::vector<Node> build(int begin, int end, int forks) {
    std::vector<Node> built;
    if (forks == 0 || end - begin <= kForkSize) {
      append(built, begin, end);
      return built;
    }
    Node root;
    const int middle = split(begin, end, root);
    std::array<std::vector<Node>, 2> halves;
    forEachChunk(2, 1, [&](std::size_t h, std::size_t) {
      halves[h] = h == 0 ? build(begin, middle, forks - 1) : build(middle, end, forks - 1);
    });
    root.left = 1;
    root.right = 1 + static_cast<int>(halves[0].size());
    built.push_back(root);
    for (const int child : {root.left, root.right})
      for (Node node : halves[child == root.left ? 0 : 1]) {
        if (node.axis >= 0) node.left += child, node.right += child;
        built.push_back(node);
      }
    return built;
  }

  /// Visits leaves that may hold a point with squared distance <= `bound()`, near side first. `gaps` are the
  /// squared distances from the query to the node's box along each axis. Their sum is formed anew in the
  /// order that squaredDistance uses, so that rounding can never make a box seem farther than a point in it.
  template <class Bound, class Leaf>
  void visit(int id, const std::array<double, 3>& query, std::array<double, 3> gaps, const Bound& bound,
             const Leaf& leaf) const {
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
    leaf(entries.data() + node->left, entries.data() + node->right);
  }

  template <class Bound, class Leaf>
  void search(const Vector3d& q, const Bound& bound, const Leaf& leaf) const {
    const std::array<double, 3> query{q.x(), q.y(), q.z()};
    std::array<double, 3> gaps{};
    for (std::size_t a = 0; a < 3; ++a) {
      const double gap = std::max({lowest[a] - query[a], query[a] - highest[a], 0.0});
      gaps[a] = gap * gap;
    }
    if (gaps[0] + gaps[1] + gaps[2] <= bound()) visit(0, query, gaps, bound, leaf);
  }

  void improve(const Vector3d& query, Neighbour& best) const {
    search(
        query, [&] { return best.squaredDistance; },
        [&](const Entry* entry, const Entry* end) {
          for (; entry != end; ++entry) {
            const double x = query.x() - entry->x, y = query.y() - entry->y, z = query.z() - entry->z;
            const double squared = x * x + y * y + z * z;
            if (nearer(squared, entry->index, best)) best = {entry->index, squared};
          }
        });
  }
};

KdTree::KdTree(const Points& points, const std::vector<int>& ids) : size_(static_cast<int>(ids.size())) {
  if (ids.empty()) return;
  auto tree = std::make_shared<Tree>();
  tree->entries.reserve(ids.size());
  for (const int i : ids) tree->entries.push_back({points(i, 0), points(i, 1), points(i, 2), i});
  tree->nodes = tree->build(0, size_, kForks);
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
      [&](const Entry* entry, const Entry* end) {
        for (; entry != end; ++entry) {
          const double squared = squaredDistance(query, {entry->x, entry->y, entry->z});
          if (found.size() == wanted) {
            if (!nearer(squared, entry->index, found.back())) continue;
            found.pop_back();
          }
          auto place = found.end();
          while (place != found.begin() && nearer(squared, entry->index, *(place - 1))) --place;
          found.insert(place, Neighbour{entry->index, squared});
          if (found.size() == wanted) farthest = found.back().squaredDistance;
        }
      });
  return found;
}

std::vector<int> KdTree::within(const Vector3d& query, double radius) const {
  std::vector<int> found;
  if (!tree_ || !(radius >= 0)) return found;
  const double bound = radius * radius;
  tree_->search(
      query, [&] { return bound; },
      [&](const Entry* entry, const Entry* end) {
        for (; entry != end; ++entry)
          if (squaredDistance(query, {entry->x, entry->y, entry->z}) <= bound) found.push_back(entry->index);
      });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace falciform
