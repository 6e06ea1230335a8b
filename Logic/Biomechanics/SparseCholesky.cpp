#include "Logic/Biomechanics/SparseCholesky.h"

#include <algorithm>
#include <atomic>

#include "Logic/Biomechanics/BufferPool.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

/// Enough subtrees that a few dozen threads stay busy, whatever their number.
constexpr std::size_t kBranches = 48;

/// P A P' of the order: lower triangle by columns.
SparseLower permuted(const SparseLower& matrix, const std::vector<std::int64_t>& order) {
  const auto size = static_cast<std::size_t>(matrix.size());
  std::vector<std::int64_t> place(size);
  for (std::size_t j = 0; j < size; ++j)
    place[static_cast<std::size_t>(order[j])] = static_cast<std::int64_t>(j);
  const auto forAll = [&](const auto& act) {
    for (std::size_t c = 0; c < size; ++c)
      for (auto at = static_cast<std::size_t>(matrix.begin[c]);
           at < static_cast<std::size_t>(matrix.begin[c + 1]); ++at) {
        const std::int64_t a = place[c], b = place[static_cast<std::size_t>(matrix.rows[at])];
        act(std::max(a, b), static_cast<std::size_t>(std::min(a, b)), matrix.values[at]);
      }
  };
  SparseLower result;
  result.begin.assign(size + 1, 0);
  forAll([&](std::int64_t, std::size_t column, double) { ++result.begin[column + 1]; });
  for (std::size_t c = 0; c < size; ++c) result.begin[c + 1] += result.begin[c];
  result.rows.resize(matrix.rows.size());
  result.values.resize(matrix.rows.size());
  std::vector<std::int64_t> next(result.begin.begin(), result.begin.end() - 1);
  forAll([&](std::int64_t row, std::size_t column, double value) {
    const auto at = static_cast<std::size_t>(next[column]++);
    result.rows[at] = row;
    result.values[at] = value;
  });
  return result;
}

/// What is left of a diagonal entry in elimination, by the entry, below which it is rounding: a body that is
/// not held leaves some 1e-16 to 1e-15 of either sign, one that is held more than 1e-10 even if slender and
/// nearly incompressible.
constexpr double kSmallestPivot = 1e-13;

double diagonalOf(const SparseLower& lower, std::int64_t column) {
  for (auto at = static_cast<std::size_t>(lower.begin[static_cast<std::size_t>(column)]);
       at < static_cast<std::size_t>(lower.begin[static_cast<std::size_t>(column) + 1]); ++at)
    if (lower.rows[at] == column) return lower.values[at];
  return 0;
}

std::vector<double> operationsOf(const SupernodalStructure& structure) {
  std::vector<double> work;
  for (std::size_t s = 0; s < structure.supernodes(); ++s) {
    const auto h = static_cast<double>(structure.height(s)), w = static_cast<double>(structure.width(s));
    work.push_back(w * h * h - w * w * h + w * w * w / 3);  // columns of height h, h - 1, ...
  }
  return work;
}

}  // namespace

/// The numeric factorisation at work: updates wait at their supernode until the parent takes them up.
struct SparseCholesky::Fronts {
  const SupernodalStructure& structure;
  const SparseLower& matrix;  ///< permuted
  double* values;
  std::vector<std::vector<int>> children;
  BufferPool pool;
  std::vector<BufferPool::Buffer> updates;  ///< lower triangle of (height - width) squared
  std::atomic<bool> definite{true};

  Fronts(const SupernodalStructure& s, const SparseLower& m, double* v)
      : structure(s), matrix(m), values(v), children(s.supernodes()), updates(s.supernodes()) {
    for (std::size_t k = 0; k < s.supernodes(); ++k)
      if (s.parents[k] >= 0) children[static_cast<std::size_t>(s.parents[k])].push_back(static_cast<int>(k));
  }

  /// `places`: as many as the matrix has rows; receives the front's rows.
  void factorise(std::size_t s, std::vector<int>& places, bool parallel);
  void addMatrix(std::size_t s, const std::vector<int>& places);
  void addUpdate(std::size_t s, std::size_t child, const std::vector<int>& places, bool parallel);
};

void SparseCholesky::Fronts::addMatrix(std::size_t s, const std::vector<int>& places) {
  const std::int64_t height = structure.height(s);
  for (std::int64_t column = structure.super[s]; column < structure.super[s + 1]; ++column) {
    double* to = values + structure.valuesBegin[s] + (column - structure.super[s]) * height;
    const auto c = static_cast<std::size_t>(column);
    for (auto at = static_cast<std::size_t>(matrix.begin[c]);
         at < static_cast<std::size_t>(matrix.begin[c + 1]); ++at)
      to[places[static_cast<std::size_t>(matrix.rows[at])]] += matrix.values[at];
  }
}

void SparseCholesky::Fronts::addUpdate(std::size_t s, std::size_t child, const std::vector<int>& places,
                                       bool parallel) {
  const std::int64_t height = structure.height(s), width = structure.width(s), rest = height - width;
  const std::int64_t size = structure.height(child) - structure.width(child);
  if (size == 0) return;
  const std::int64_t* rows = structure.rows.data() + structure.rowsBegin[child] + structure.width(child);
  std::vector<std::int64_t> there(static_cast<std::size_t>(size));
  for (std::int64_t k = 0; k < size; ++k)
    there[static_cast<std::size_t>(k)] = places[static_cast<std::size_t>(rows[k])];
  const double* from = updates[child].data.get();
  const auto columns = [&](std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j) {
      const std::int64_t column = there[j];
      double* to = column < width ? values + structure.valuesBegin[s] + column * height
                                  : updates[s].data.get() + (column - width) * rest - width;
      const double* source = from + static_cast<std::int64_t>(j) * size;
      for (auto i = static_cast<std::int64_t>(j); i < size; ++i)
        to[there[static_cast<std::size_t>(i)]] += source[i];
    }
  };
  if (parallel)
    forEachChunk(static_cast<std::size_t>(size), 64, columns);
  else
    columns(0, static_cast<std::size_t>(size));
  pool.giveBack(std::move(updates[child]));
}

void SparseCholesky::Fronts::factorise(std::size_t s, std::vector<int>& places, bool parallel) {
  const std::int64_t height = structure.height(s), width = structure.width(s), rest = height - width;
  for (std::int64_t k = 0; k < height; ++k)
    places[static_cast<std::size_t>(structure.rows[static_cast<std::size_t>(structure.rowsBegin[s] + k)])] =
        static_cast<int>(k);
  double* panel = values + structure.valuesBegin[s];
  std::fill_n(panel, height * width, 0.0);
  if (rest > 0) {
    updates[s] = pool.take(static_cast<std::size_t>(rest * rest));
    for (std::int64_t j = 0; j < rest; ++j)  // its lower triangle
      std::fill(updates[s].data.get() + j * rest + j, updates[s].data.get() + (j + 1) * rest, 0.0);
  }
  addMatrix(s, places);
  for (const int child : children[s]) addUpdate(s, static_cast<std::size_t>(child), places, parallel);
  std::vector<double> diagonal;  // of the matrix itself
  for (std::int64_t column = structure.super[s]; column < structure.super[s + 1]; ++column)
    diagonal.push_back(diagonalOf(matrix, column));
  if (!factorisePanel(panel, height, width, updates[s].data.get(), parallel)) definite = false;
  for (std::int64_t k = 0; k < width; ++k) {
    const double root = panel[k * height + k];
    if (!(root * root > kSmallestPivot * diagonal[static_cast<std::size_t>(k)])) definite = false;
  }
}

SparseCholesky::SparseCholesky(const SparseLower& matrix, const std::vector<std::int64_t>& order,
                               const Progress& progress) {
  keepBlasSingleThreaded();
  progress.report(0, "Analysing the stiffness");
  structure_ = analyseSupernodes(matrix, order);
  const std::vector<double> work = operationsOf(structure_);
  cut_ = cutForest(structure_.parents, work, kBranches);
  for (const double w : work) operations_ += w;
  values_ = largeArray<double>(static_cast<std::size_t>(entries()));
  const SparseLower ordered = permuted(matrix, structure_.order);
  progress.report(0.1, "Factorising the stiffness");
  Fronts fronts(structure_, ordered, values_.get());
  forEachChunk(cut_.branches.size(), 1, [&](std::size_t first, std::size_t last) {
    std::vector<int> places(order.size());
    for (std::size_t b = first; b < last; ++b)
      for (const int s : cut_.branches[b])
        if (fronts.definite && !progress.stopRequested())
          fronts.factorise(static_cast<std::size_t>(s), places, false);
  });
  std::vector<int> places(order.size());
  double done = operations_;
  for (const int s : cut_.trunk) done -= work[static_cast<std::size_t>(s)];
  for (const int s : cut_.trunk) {
    progress.report(0.1 + 0.9 * done / operations_);
    if (fronts.definite) fronts.factorise(static_cast<std::size_t>(s), places, true);
    done += work[static_cast<std::size_t>(s)];
  }
  if (!fronts.definite)
    throw InputError(
        "the stiffness is not positive definite: the supports do not hold every piece of the mesh, or an "
        "element "
        "is nearly flat; add supports or mesh anew");
  progress.report(1);
}

void SparseCholesky::solve(Eigen::MatrixXd& x) const {
  keepBlasSingleThreaded();
  const Index columns = x.cols();
  Eigen::MatrixXd y(x.rows(), columns);
  for (Index j = 0; j < x.rows(); ++j) y.row(j) = x.row(structure_.order[static_cast<std::size_t>(j)]);
  // Forwards as the fronts went: what a supernode subtracts from rows above waits for its parent, so that no
  // two branches write one row and the sums' order is fixed.
  std::vector<Eigen::MatrixXd> waiting(structure_.supernodes());
  std::vector<std::vector<int>> children(structure_.supernodes());
  for (std::size_t s = 0; s < structure_.supernodes(); ++s)
    if (structure_.parents[s] >= 0)
      children[static_cast<std::size_t>(structure_.parents[s])].push_back(static_cast<int>(s));
  const auto forwards = [&](std::size_t s, std::vector<int>& places) {
    const std::int64_t height = structure_.height(s), width = structure_.width(s),
                       first = structure_.super[s];
    const std::int64_t* rows = structure_.rows.data() + structure_.rowsBegin[s];
    for (std::int64_t k = 0; k < height; ++k) places[static_cast<std::size_t>(rows[k])] = static_cast<int>(k);
    Eigen::MatrixXd front = Eigen::MatrixXd::Zero(height, columns);
    front.topRows(width) = y.middleRows(first, width);
    for (const int child : children[s]) {
      const auto c = static_cast<std::size_t>(child);
      const std::int64_t* from = structure_.rows.data() + structure_.rowsBegin[c] + structure_.width(c);
      for (Index k = 0; k < waiting[c].rows(); ++k)
        front.row(places[static_cast<std::size_t>(from[k])]) += waiting[c].row(k);
      waiting[c].resize(0, 0);
    }
    const double* panel = values_.get() + structure_.valuesBegin[s];
    solveLower(panel, height, width, front.data(), height, columns);
    y.middleRows(first, width) = front.topRows(width);
    if (height == width) return;
    subtractProduct(panel + width, height, height - width, width, front.data(), height, front.data() + width,
                    height, columns);
    waiting[s] = front.bottomRows(height - width);
  };
  const auto backwards = [&](std::size_t s) {
    const std::int64_t height = structure_.height(s), width = structure_.width(s),
                       first = structure_.super[s];
    const std::int64_t* rows = structure_.rows.data() + structure_.rowsBegin[s];
    Eigen::MatrixXd above(height - width, columns);
    for (std::int64_t k = width; k < height; ++k) above.row(k - width) = y.row(rows[k]);
    const double* panel = values_.get() + structure_.valuesBegin[s];
    subtractTransposedProduct(panel + width, height, height - width, width, above.data(),
                              std::max<Index>(above.rows(), 1), y.data() + first, y.rows(), columns);
    solveLowerTransposed(panel, height, width, y.data() + first, y.rows(), columns);
  };
  forEachChunk(cut_.branches.size(), 1, [&](std::size_t b, std::size_t end) {
    std::vector<int> places(structure_.order.size());
    for (; b < end; ++b)
      for (const int s : cut_.branches[b]) forwards(static_cast<std::size_t>(s), places);
  });
  std::vector<int> places(structure_.order.size());
  for (const int s : cut_.trunk) forwards(static_cast<std::size_t>(s), places);
  for (auto s = cut_.trunk.rbegin(); s != cut_.trunk.rend(); ++s) backwards(static_cast<std::size_t>(*s));
  forEachChunk(cut_.branches.size(), 1, [&](std::size_t b, std::size_t end) {
    for (; b < end; ++b)
      for (auto s = cut_.branches[b].rbegin(); s != cut_.branches[b].rend(); ++s)
        backwards(static_cast<std::size_t>(*s));
  });
  for (Index j = 0; j < x.rows(); ++j) x.row(structure_.order[static_cast<std::size_t>(j)]) = y.row(j);
}

}  // namespace falciform
