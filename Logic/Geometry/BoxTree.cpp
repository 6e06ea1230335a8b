#include "Logic/Geometry/BoxTree.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace falciform {

namespace {

using Corner = Eigen::Array4f;  // x, y, z and nothing: four lanes are one instruction

struct Box {
  Corner low, high;

  void add(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  [[nodiscard]] float halfArea() const {
    const Corner edge = (high - low).max(0.0F);
    return edge[0] * edge[1] + edge[1] * edge[2] + edge[2] * edge[0];
  }
};

const Box kNothing{Corner::Constant(std::numeric_limits<float>::infinity()),
                   Corner::Constant(-std::numeric_limits<float>::infinity())};

struct Item {
  Box box;
  int id = 0;
  [[nodiscard]] Corner middle() const { return 0.5F * (box.low + box.high); }
};

struct Run {
  int begin = 0, end = 0;
  Box box = kNothing;
  [[nodiscard]] int size() const { return end - begin; }
};

constexpr std::size_t kMostBins = 16, kFewBins = 4;
constexpr int kFewItems = 64;

/// The items' places along three axes, in `count` bins each.
struct Bins {
  std::size_t count;
  Corner low, perMm;

  Bins(std::size_t binCount, const Corner& lowest, const Corner& extent)
      : count(binCount),
        low(lowest),
        perMm((extent > 0).select(static_cast<float>(binCount) / extent, Corner::Zero())) {}

  /// Of an item whose middle is the given one; along an axis without extent all are in bin 0.
  [[nodiscard]] Eigen::Array4i of(const Corner& middle) const {
    return ((middle - low) * perMm).max(0.0F).min(static_cast<float>(count - 1)).cast<int>();
  }
};

struct Bin {
  Box box;
  int items;
};

}  // namespace

struct BoxTree::Builder {
  BoxTree& tree;
  std::vector<Item> items;  ///< in the order of the leaves as far as that is settled

  [[nodiscard]] Box boxOf(int begin, int end) const {
    Box box = kNothing;
    for (int i = begin; i < end; ++i) box.add(items[static_cast<std::size_t>(i)].box);
    return box;
  }

  /// Cuts a run in two where the surface-area heuristic says, after sorting it so; halves it where there is
  /// nothing to choose.
  std::pair<Run, Run> cut(const Run& run, int depth) {
    const auto begin = items.begin() + run.begin, end = items.begin() + run.end;
    Box spread = kNothing;
    for (auto item = begin; item != end; ++item) {
      const Corner middle = item->middle();
      spread.add({middle, middle});
    }
    const Corner extent = spread.high - spread.low;
    const float widest = extent.head<3>().maxCoeff();
    const Bins bins(run.size() < kFewItems ? kFewBins : kMostBins, spread.low, extent);
    std::array<std::array<Bin, kMostBins>, 3> bin;
    for (auto& along : bin) std::fill_n(along.begin(), bins.count, Bin{kNothing, 0});
    for (auto item = begin; item != end; ++item) {
      const Eigen::Array4i at = bins.of(item->middle());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Bin& own = bin[axis][static_cast<std::size_t>(at[static_cast<Index>(axis)])];
        own.box.add(item->box);
        ++own.items;
      }
    }
    float best = std::numeric_limits<float>::infinity();
    int bestAxis = -1, bestBin = 0;
    Run left{run.begin, run.begin}, right{run.end, run.end};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(extent[static_cast<Index>(axis)] > 0.2F * widest)) continue;  // across a thin side never pays
      std::array<Box, kMostBins> above;
      Box box = kNothing;
      for (std::size_t b = bins.count - 1; b > 0; --b) {
        box.add(bin[axis][b].box);
        above[b] = box;
      }
      box = kNothing;
      int n = 0;
      for (std::size_t b = 0; b + 1 < bins.count; ++b) {
        box.add(bin[axis][b].box);
        n += bin[axis][b].items;
        if (n == 0 || n == run.size()) continue;
        const float cost = box.halfArea() * static_cast<float>(n) +
                           above[b + 1].halfArea() * static_cast<float>(run.size() - n);
        if (cost >= best) continue;
        best = cost;
        bestAxis = static_cast<int>(axis);
        bestBin = static_cast<int>(b);
        left.box = box;
        right.box = above[b + 1];
      }
    }
    if (bestAxis >= 0 && depth < 24) {
      const auto middle = std::stable_partition(
          begin, end, [&](const Item& item) { return bins.of(item.middle())[bestAxis] <= bestBin; });
      left.end = right.begin = static_cast<int>(middle - items.begin());
      return {left, right};
    }
    // All middles in one place, or a pathological depth: halves keep the depth, and so the query's stack,
    // bounded.
    Index axis = 0;
    extent.head<3>().maxCoeff(&axis);
    std::nth_element(begin, begin + run.size() / 2, end, [&](const Item& a, const Item& b) {
      const float x = a.middle()[axis], y = b.middle()[axis];
      return x < y || (x == y && a.id < b.id);
    });
    left.end = right.begin = run.begin + run.size() / 2;
    left.box = boxOf(left.begin, left.end);
    right.box = boxOf(right.begin, right.end);
    return {left, right};
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
      std::tie(runs[static_cast<std::size_t>(widest)], runs[static_cast<std::size_t>(count)]) =
          cut(runs[static_cast<std::size_t>(widest)], depth);
      ++count;
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
  Builder builder{*this, std::vector<Item>(n)};
  const auto corner = [&](const Points& of, std::size_t i, float widened) {
    Corner made = Corner::Zero();
    made.head<3>() = (of.row(static_cast<Index>(i)).transpose() - centre_).cast<float>().array() + widened;
    return made;
  };
  for (std::size_t i = 0; i < n; ++i)
    builder.items[i] = {{corner(low, i, -pad), corner(high, i, pad)}, static_cast<int>(i)};
  builder.build({0, static_cast<int>(n), builder.boxOf(0, static_cast<int>(n))}, 0);
  order_.resize(n);
  for (std::size_t i = 0; i < n; ++i) order_[i] = builder.items[i].id;
}

}  // namespace falciform
