#include "Logic/Biomechanics/BackSubstitution.h"

#include <algorithm>

#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"

namespace falciform {

BackSubstitution::BackSubstitution(const SparseCholesky& factor, std::int64_t last) {
  const SupernodalStructure& structure = factor.structure();
  const auto given = static_cast<std::int64_t>(structure.order.size()) - last;
  std::vector<int> panelOf(structure.supernodes(), -1), parents;
  std::vector<double> work;
  std::int64_t numbers = 0;
  for (std::size_t s = 0; s < structure.supernodes(); ++s)
    numbers += std::max<std::int64_t>(0, std::min(structure.super[s + 1], given) - structure.super[s]) *
               structure.height(s);
  values_ = largeArray<float>(static_cast<std::size_t>(numbers));
  std::int64_t filled = 0;
  for (std::size_t s = 0; s < structure.supernodes(); ++s) {
    const std::int64_t first = structure.super[s], width = std::min(structure.super[s + 1], given) - first;
    if (width <= 0) continue;
    const std::int64_t height = structure.height(s);
    panelOf[s] = static_cast<int>(panels_.size());
    panels_.push_back({first, width, height, filled, static_cast<std::int64_t>(rows_.size())});
    const double* from = factor.values() + structure.valuesBegin[s];
    std::copy(from, from + width * height, values_.get() + filled);
    filled += width * height;
    const auto rows = structure.rows.begin() + structure.rowsBegin[s];
    rows_.insert(rows_.end(), rows, rows + height);
    work.push_back(static_cast<double>(width * height));
  }
  for (std::size_t s = 0; s < structure.supernodes(); ++s)
    if (panelOf[s] >= 0)
      parents.push_back(structure.parents[s] < 0 ? -1
                                                 : panelOf[static_cast<std::size_t>(structure.parents[s])]);
  constexpr std::size_t kBranches = 24;
  cut_ = cutForest(parents, work, kBranches);
}

void BackSubstitution::solvePanel(const Panel& panel, Eigen::MatrixXf& values, bool parallel,
                                  std::vector<float>& space) const {
  const Index columns = values.cols();
  const std::int64_t below = panel.height - panel.width;
  space.resize(static_cast<std::size_t>(below * columns));
  for (Index c = 0; c < columns; ++c)
    for (std::int64_t r = 0; r < below; ++r)
      space[static_cast<std::size_t>(c * below + r)] =
          values(rows_[static_cast<std::size_t>(panel.rows + panel.width + r)], c);
  const float* lower = values_.get() + panel.values;
  values.middleRows(panel.firstColumn, panel.width).setZero();
  float* own = values.data() + panel.firstColumn;
  const auto subtract = [&](std::size_t first, std::size_t last) {
    const auto at = static_cast<Index>(first);
    subtractTransposedProduct(lower + at * panel.height + panel.width, panel.height, below,
                              static_cast<Index>(last - first), space.data(), std::max<Index>(below, 1),
                              own + at, values.rows(), columns);
  };
  if (parallel)
    forEachChunk(static_cast<std::size_t>(panel.width), 64, subtract);
  else
    subtract(0, static_cast<std::size_t>(panel.width));
  solveLowerTransposed(lower, panel.height, panel.width, own, values.rows(), columns);
}

void BackSubstitution::solve(Eigen::MatrixXf& values) const {
  keepBlasSingleThreaded();
  std::vector<float> space;
  for (auto p = cut_.trunk.rbegin(); p != cut_.trunk.rend(); ++p)
    solvePanel(panels_[static_cast<std::size_t>(*p)], values, true, space);
  forEachChunk(cut_.branches.size(), 1, [&](std::size_t first, std::size_t end) {
    std::vector<float> own;
    for (std::size_t b = first; b < end; ++b)
      for (auto p = cut_.branches[b].rbegin(); p != cut_.branches[b].rend(); ++p)
        solvePanel(panels_[static_cast<std::size_t>(*p)], values, false, own);
  });
}

}  // namespace falciform
