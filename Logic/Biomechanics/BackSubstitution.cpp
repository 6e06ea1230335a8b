#include "Logic/Biomechanics/BackSubstitution.h"

#include <algorithm>
#include <queue>

#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

/// Enough branches that a few threads stay busy, whatever the number of threads.
constexpr std::size_t kBranches = 24;

/// Splits a forest into a trunk at its roots and at least kBranches subtrees below, heaviest split first.
/// `parents[p]` > p, or -1.
void splitForest(const std::vector<int>& parents, const std::vector<double>& work, std::vector<int>& trunk,
                 std::vector<std::vector<int>>& branches) {
  const std::size_t count = parents.size();
  std::vector<double> weight = work;
  std::vector<std::vector<int>> children(count);
  std::priority_queue<std::pair<double, int>> heaviest;
  for (std::size_t p = 0; p < count; ++p)
    if (parents[p] >= 0) {
      weight[static_cast<std::size_t>(parents[p])] += weight[p];
      children[static_cast<std::size_t>(parents[p])].push_back(static_cast<int>(p));
    }
  for (std::size_t p = 0; p < count; ++p)
    if (parents[p] < 0) heaviest.emplace(weight[p], static_cast<int>(p));
  while (!heaviest.empty() && heaviest.size() < kBranches) {
    const int p = heaviest.top().second;
    heaviest.pop();
    trunk.push_back(p);
    for (const int child : children[static_cast<std::size_t>(p)])
      heaviest.emplace(weight[static_cast<std::size_t>(child)], child);
  }
  std::sort(trunk.rbegin(), trunk.rend());
  for (; !heaviest.empty(); heaviest.pop()) {
    std::vector<int> branch{heaviest.top().second};
    for (std::size_t k = 0; k < branch.size(); ++k)
      for (const int child : children[static_cast<std::size_t>(branch[k])]) branch.push_back(child);
    branches.push_back(std::move(branch));
  }
}

}  // namespace

BackSubstitution::BackSubstitution(const SupernodalView& factor, std::int64_t last) {
  const auto given = static_cast<std::int64_t>(factor.order.size()) - last;
  std::vector<int> panelOfColumn(static_cast<std::size_t>(given), -1);
  for (std::size_t s = 0; s + 1 < factor.super.size(); ++s) {
    const std::int64_t first = factor.super[s], width = std::min(factor.super[s + 1], given) - first;
    if (width <= 0) continue;
    const std::int64_t height = factor.rowsBegin[s + 1] - factor.rowsBegin[s];
    const auto panel = static_cast<int>(panels_.size());
    panels_.push_back({first, width, height, static_cast<std::int64_t>(values_.size()),
                       static_cast<std::int64_t>(rows_.size())});
    const double* from = factor.values + factor.valuesBegin[s];
    values_.insert(values_.end(), from, from + width * height);
    const auto rows =
        factor.rows.subspan(static_cast<std::size_t>(factor.rowsBegin[s]), static_cast<std::size_t>(height));
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    std::fill_n(panelOfColumn.begin() + first, width, panel);
  }
  std::vector<int> parents;
  std::vector<double> work;
  for (const Panel& panel : panels_) {
    const std::int64_t parent =
        panel.height > panel.width ? rows_[static_cast<std::size_t>(panel.rows + panel.width)] : given;
    parents.push_back(parent < given ? panelOfColumn[static_cast<std::size_t>(parent)] : -1);
    work.push_back(static_cast<double>(panel.width * panel.height));
  }
  splitForest(parents, work, trunk_, branches_);
}

void BackSubstitution::solvePanel(const Panel& panel, Eigen::MatrixXf& values,
                                  std::vector<float>& space) const {
  const auto columns = static_cast<int>(values.cols());
  const std::int64_t below = panel.height - panel.width;
  space.resize(static_cast<std::size_t>(below * columns));
  for (int c = 0; c < columns; ++c)
    for (std::int64_t r = 0; r < below; ++r)
      space[static_cast<std::size_t>(c * below + r)] =
          values(rows_[static_cast<std::size_t>(panel.rows + panel.width + r)], c);
  const float* lower = values_.data() + panel.values;
  float* own = values.data() + panel.firstColumn;
  const auto width = static_cast<int>(panel.width), height = static_cast<int>(panel.height);
  const auto stride = static_cast<int>(values.rows());
  for (int c = 0; c < columns; ++c) std::fill_n(own + static_cast<std::int64_t>(c) * stride, width, 0.0F);
  subtractTransposed(static_cast<int>(below), width, columns, lower + width, height, space.data(),
                     static_cast<int>(std::max<std::int64_t>(below, 1)), own, stride);
  solveTransposedLower(width, columns, lower, height, own, stride);
}

void BackSubstitution::solve(Eigen::MatrixXf& values) const {
  keepBlasSingleThreaded();
  std::vector<float> space;
  for (const int p : trunk_) solvePanel(panels_[static_cast<std::size_t>(p)], values, space);
  forEachChunk(branches_.size(), 1, [&](std::size_t first, std::size_t end) {
    std::vector<float> own;
    for (std::size_t b = first; b < end; ++b)
      for (const int p : branches_[b]) solvePanel(panels_[static_cast<std::size_t>(p)], values, own);
  });
}

}  // namespace falciform
