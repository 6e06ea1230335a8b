#include "Logic/Geometry/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace falciform {

namespace {

struct Box {
  Eigen::Array3f low = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array3f high = -low;

  void add(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  [[nodiscard]] float halfArea() const {
    const Eigen::Array3f edge = (high - low).max(0.0F);
    return edge[0] * edge[1] + edge[1] * edge[2] + edge[2] * edge[0];
  }
};

struct Run {
  int begin = 0, end = 0;
  Box box;
  [[nodiscard]] int size() const { return end - begin; }
};

}  // namespace

struct BoxTree::Builder {
  BoxTree& tree;
  std::vector<Box> boxes;               ///< of each item
  std::vector<Eigen::Array3f> middles;  ///< of each item's box

  [[nodiscard]] Box boxOf(int begin, int end) const {
    Box box;
    for (int i = begin; i < end; ++i) box.add(boxes[item(i)]);
    return box;
  }
  [[nodiscard]] std::size_t item(int place) const {
    return static_cast<std::size_t>(tree.order_[static_cast<std::size_t>(place)]);
  }

  /// Where the surface-area heuristic cuts a run, after sorting it so; halves it where there is nothing to
  /// choose.
  int cut(const Run& run, int depth) {
    constexpr int kBins = 16;
    Box spread;
    for (int i = run.begin; i < run.end; ++i) spread.add({middles[item(i)], middles[item(i)]});
    const Eigen::Array3f extent = spread.high - spread.low;
    float best = std::numeric_limits<float>::infinity();
    int bestAxis = -1, bestBin = 0;
    const auto binOf = [&](std::size_t id, int axis) {
      const float share = (middles[id][axis] - spread.low[axis]) / extent[axis];
      return std::clamp(static_cast<int>(share * kBins), 0, kBins - 1);
    };
    for (int axis = 0; axis < 3; ++axis) {
      if (!(extent[axis] > 0.2F * extent.maxCoeff())) continue;  // a cut across a thin side never pays
      std::array<Box, kBins> bin;
      std::array<int, kBins> count{};
      for (int i = run.begin; i < run.end; ++i) {
        const auto b = static_cast<std::size_t>(binOf(item(i), axis));
        bin[b].add(boxes[item(i)]);
        ++count[b];
      }
      std::array<float, kBins> right{};
      Box box;
      for (int b = kBins - 1, n = 0; b > 0; --b) {
        box.add(bin[static_cast<std::size_t>(b)]);
        n += count[static_cast<std::size_t>(b)];
        right[static_cast<std::size_t>(b)] = n > 0 ? box.halfArea() * static_cast<float>(n) : 0;
      }
      box = {};
      for (int b = 0, n = 0; b + 1 < kBins; ++b) {
        box.add(bin[static_cast<std::size_t>(b)]);
        n += count[static_cast<std::size_t>(b)];
        if (n == 0 || n == run.size()) continue;
        const float cost = box.halfArea() * static_cast<float>(n) + right[static_cast<std::size_t>(b) + 1];
        if (cost < best) best = cost, bestAxis = axis, bestBin = b;
      }
    }
    const auto begin = tree.order_.begin() + run.begin, end = tree.order_.begin() + run.end;
    if (bestAxis >= 0 && depth < 24) {
      const auto middle = std::stable_partition(
          begin, end, [&](int id) { return binOf(static_cast<std::size_t>(id), bestAxis) <= bestBin; });
      return static_cast<int>(middle - tree.order_.begin());
    }
    // All middles in one place, or a pathological depth: halves keep the depth, and so the query's stack,
    // bounded.
    Index axis = 0;
    extent.maxCoeff(&axis);
    const auto middle = begin + run.size() / 2;
    std::nth_element(begin, middle, end, [&](int a, int b) {
      const float x = middles[static_cast<std::size_t>(a)][axis],
                  y = middles[static_cast<std::size_t>(b)][axis];
      return x < y || (x == y && a < b);
    });
    return static_cast<int>(middle - tree.order_.begin());
  }

  int build(const Run& whole, int depth) {
    std::array<Run, kWidth> runs{whole};
    int count = 1;
    while (count < kWidth) {
      int widest = -1;  // open the largest box that is too full for a leaf
      for (int i = 0; i < count; ++i) {
        const Run& run = runs[static_cast<std::size_t>(i)];
        if (run.size() <= kLeafItems) continue;
        if (widest < 0 || run.box.halfArea() > runs[static_cast<std::size_t>(widest)].box.halfArea())
          widest = i;
      }
      if (widest < 0) break;
      const Run run = runs[static_cast<std::size_t>(widest)];
      const int at = cut(run, depth);
      runs[static_cast<std::size_t>(widest)] = {run.begin, at, boxOf(run.begin, at)};
      runs[static_cast<std::size_t>(count++)] = {at, run.end, boxOf(at, run.end)};
    }
    const int index = static_cast<int>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    Node node;
    node.children = count;
    for (int lane = 0; lane < kWidth; ++lane) {
      const auto i = static_cast<std::size_t>(lane);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.low[axis][lane] = lane < count ? runs[i].box.low[static_cast<Index>(axis)] : 0;
        node.high[axis][lane] = lane < count ? runs[i].box.high[static_cast<Index>(axis)] : 0;
      }
      if (lane >= count) continue;
      const bool leaf = runs[i].size() <= kLeafItems;
      node.items[i] = static_cast<std::uint8_t>(leaf ? runs[i].size() : 0);
      node.child[i] = leaf ? runs[i].begin : build(runs[i], depth + 1);
    }
    tree.nodes_[static_cast<std::size_t>(index)] = node;
    return index;
  }
};

BoxTree::BoxTree(const Points& low, const Points& high) {
  const Vector3d lowest = low.colwise().minCoeff(), highest = high.colwise().maxCoeff();
  centre_ = 0.5 * (lowest + highest);
  radius_ =
      0.5 * (highest - lowest).norm() * 1.000001 + 1e-12 * centre_.norm() + std::numeric_limits<float>::min();
  const auto pad = static_cast<float>(1e-6 * radius_);  // 16 float roundings at the rim
  const auto n = static_cast<std::size_t>(low.rows());
  Builder builder{*this, std::vector<Box>(n), std::vector<Eigen::Array3f>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Index>(i);
    builder.boxes[i].low = (low.row(row).transpose() - centre_).cast<float>().array() - pad;
    builder.boxes[i].high = (high.row(row).transpose() - centre_).cast<float>().array() + pad;
    builder.middles[i] = 0.5F * (builder.boxes[i].low + builder.boxes[i].high);
  }
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), 0);
  builder.build({0, static_cast<int>(n), builder.boxOf(0, static_cast<int>(n))}, 0);
}

}  // namespace falciform
