#include "Logic/Biomechanics/SparseCholesky.h"

#include "Logic/Core/Errors.h"

#ifndef FALCIFORM_WITH_CHOLMOD

namespace falciform {

struct SparseCholesky::Factor {};

namespace {
[[noreturn]] void refuse() {
  throw InputError(
      "this build is without CHOLMOD, so it cannot solve for deformations; build with "
      "-DFALCIFORM_WITH_CHOLMOD=ON (Docs/Licences.md says what that means)");
}
}  // namespace

std::vector<int> nestedDissection(const NodeGraph&, const std::vector<char>&) { refuse(); }
SparseCholesky::SparseCholesky(const SparseLower&, const std::vector<std::int64_t>&, const Progress&) {
  refuse();
}
void SparseCholesky::solve(Eigen::MatrixXd&) const { refuse(); }
double SparseCholesky::entries() const { return 0; }
SupernodalView SparseCholesky::supernodes() const { return {}; }

}  // namespace falciform

#else

#include <suitesparse/cholmod.h>

#include <mutex>
#include <new>
#include <string>

#include "Logic/Biomechanics/DenseAlgebra.h"

namespace falciform {
namespace {

/// CHOLMOD's workspace and error state.
struct Common {
  cholmod_common state{};
  Common() {
    cholmod_l_start(&state);
    state.print = 0;
    state.supernodal = CHOLMOD_SUPERNODAL;
    state.nmethods = 1;
    state.method[0].ordering = CHOLMOD_GIVEN;
    state.postorder = 1;
    state.quick_return_if_not_posdef = 1;
  }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  ~Common() { cholmod_l_finish(&state); }
};

/// A view of our arrays as CHOLMOD's matrix; nothing is copied or owned.
cholmod_sparse viewOf(const SparseLower& matrix, bool pattern) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.size());
  view.nzmax = matrix.rows.size();
  view.p = const_cast<std::int64_t*>(matrix.begin.data());
  view.i = const_cast<std::int64_t*>(matrix.rows.data());
  view.x = pattern ? nullptr : const_cast<double*>(matrix.values.data());
  view.stype = -1;
  view.itype = CHOLMOD_LONG;
  view.xtype = pattern ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

void checkMemory(const cholmod_common& state) {
  if (state.status == CHOLMOD_OUT_OF_MEMORY || state.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
}

}  // namespace

std::vector<int> nestedDissection(const NodeGraph& graph, const std::vector<char>& kept) {
  std::vector<int> nodes, place(static_cast<std::size_t>(graph.nodes()), -1);
  for (Index i = 0; i < graph.nodes(); ++i) {
    if (!kept.empty() && kept[static_cast<std::size_t>(i)] == 0) continue;
    place[static_cast<std::size_t>(i)] = static_cast<int>(nodes.size());
    nodes.push_back(static_cast<int>(i));
  }
  SparseLower pattern{.begin = {0}, .rows = {}, .values = {}};
  for (const int node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    for (std::size_t at = graph.begin[i]; at < graph.begin[i + 1]; ++at) {
      const int j = graph.neighbours[at];
      if (j >= node && place[static_cast<std::size_t>(j)] >= 0)
        pattern.rows.push_back(place[static_cast<std::size_t>(j)]);
    }
    pattern.begin.push_back(static_cast<std::int64_t>(pattern.rows.size()));
  }
  if (nodes.empty()) return nodes;
  Common common;
  cholmod_sparse view = viewOf(pattern, true);
  std::vector<SuiteSparse_long> order(nodes.size());
  cholmod_l_metis(&view, nullptr, 0, 1, order.data(), &common.state);
  checkMemory(common.state);
  std::vector<int> result(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) result[k] = nodes[static_cast<std::size_t>(order[k])];
  return result;
}

struct SparseCholesky::Factor {
  Common common;
  cholmod_factor* factor = nullptr;
  std::mutex guard;  ///< CHOLMOD's workspace serves one solve at a time
  Factor() = default;
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  ~Factor() { cholmod_l_free_factor(&factor, &common.state); }
};

SparseCholesky::SparseCholesky(const SparseLower& matrix, const std::vector<std::int64_t>& order,
                               const Progress& progress)
    : factor_(std::make_shared<Factor>()) {
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  keepBlasSingleThreaded();
  progress.report(0, "Factorising the stiffness");
  cholmod_common* state = &factor_->common.state;
  cholmod_sparse view = viewOf(matrix, false);
  std::vector<SuiteSparse_long> given(order.begin(), order.end());
  factor_->factor = cholmod_l_analyze_p(&view, given.data(), nullptr, 0, state);
  checkMemory(*state);
  if (factor_->factor == nullptr) throw std::runtime_error("CHOLMOD could not analyse the stiffness matrix");
  progress.report(0.1);
  cholmod_l_factorize(&view, factor_->factor, state);
  checkMemory(*state);
  if (state->status == CHOLMOD_NOT_POSDEF || factor_->factor->minor < factor_->factor->n)
    throw InputError(
        "the stiffness is not positive definite: the supports do not hold every piece of the mesh, or an "
        "element is "
        "nearly flat; add supports or mesh anew");
  progress.report(1);
}

void SparseCholesky::solve(Eigen::MatrixXd& rightHandSides) const {
  const std::lock_guard lock(factor_->guard);
  keepBlasSingleThreaded();
  cholmod_dense view{};
  view.nrow = view.d = static_cast<std::size_t>(rightHandSides.rows());
  view.ncol = static_cast<std::size_t>(rightHandSides.cols());
  view.nzmax = view.nrow * view.ncol;
  view.x = rightHandSides.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  cholmod_common* state = &factor_->common.state;
  cholmod_dense* solution = cholmod_l_solve(CHOLMOD_A, factor_->factor, &view, state);
  checkMemory(*state);
  rightHandSides = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution->x),
                                                     rightHandSides.rows(), rightHandSides.cols());
  cholmod_l_free_dense(&solution, state);
}

double SparseCholesky::entries() const { return static_cast<double>(factor_->factor->xsize); }

SupernodalView SparseCholesky::supernodes() const {
  const cholmod_factor& f = *factor_->factor;
  const auto span = [](const void* from, std::size_t count) {
    return std::span<const std::int64_t>(static_cast<const std::int64_t*>(from), count);
  };
  return {.super = span(f.super, f.nsuper + 1),
          .rowsBegin = span(f.pi, f.nsuper + 1),
          .valuesBegin = span(f.px, f.nsuper + 1),
          .rows = span(f.s, f.ssize),
          .order = span(f.Perm, f.n),
          .values = static_cast<const double*>(f.x)};
}

}  // namespace falciform

#endif
