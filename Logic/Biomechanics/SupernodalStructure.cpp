#include "Logic/Biomechanics/SupernodalStructure.h"

#include "Logic/Core/Errors.h"

#ifndef FALCIFORM_WITH_CHOLMOD

namespace falciform {
namespace {
[[noreturn]] void refuse() {
  throw InputError(
      "this build is without CHOLMOD, so it cannot solve for deformations; build with "
      "-DFALCIFORM_WITH_CHOLMOD=ON (Docs/Licences.md says what that means)");
}
}  // namespace

std::vector<int> nestedDissection(const NodeGraph&, const std::vector<char>&) { refuse(); }
SupernodalStructure analyseSupernodes(const SparseLower&, const std::vector<std::int64_t>&) { refuse(); }

}  // namespace falciform

#else

#include <suitesparse/cholmod.h>

#include <new>
#include <stdexcept>

namespace falciform {
namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

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
  }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  ~Common() { cholmod_l_finish(&state); }

  void check() const {
    if (state.status == CHOLMOD_OUT_OF_MEMORY || state.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
  }
};

/// A view of our arrays as CHOLMOD's pattern; nothing is copied or owned.
cholmod_sparse patternOf(const SparseLower& matrix) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(matrix.size());
  view.nzmax = matrix.rows.size();
  view.p = const_cast<std::int64_t*>(matrix.begin.data());
  view.i = const_cast<std::int64_t*>(matrix.rows.data());
  view.stype = -1;
  view.itype = CHOLMOD_LONG;
  view.xtype = CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

std::vector<std::int64_t> numbers(const void* from, std::size_t count) {
  const auto* first = static_cast<const std::int64_t*>(from);
  return {first, first + count};
}

}  // namespace

std::vector<int> nestedDissection(const NodeGraph& graph, const std::vector<char>& kept) {
  std::vector<int> nodes, place(static_cast<std::size_t>(graph.nodes()), -1);
  for (Index i = 0; i < graph.nodes(); ++i) {
    if (!kept.empty() && kept[static_cast<std::size_t>(i)] == 0) continue;
    place[static_cast<std::size_t>(i)] = static_cast<int>(nodes.size());
    nodes.push_back(static_cast<int>(i));
  }
  if (nodes.empty()) return nodes;
  SparseLower pattern{.begin = {0}, .rows = {}, .values = {}};
  for (const int node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    for (std::size_t at = graph.begin[i]; at < graph.begin[i + 1]; ++at) {
      const int j = graph.neighbours[at], there = place[static_cast<std::size_t>(j)];
      if (j >= node && there >= 0) pattern.rows.push_back(there);
    }
    pattern.begin.push_back(static_cast<std::int64_t>(pattern.rows.size()));
  }
  Common common;
  cholmod_sparse view = patternOf(pattern);
  std::vector<SuiteSparse_long> order(nodes.size());
  const bool done = cholmod_l_metis(&view, nullptr, 0, 1, order.data(), &common.state) != 0;
  common.check();
  if (!done) throw std::runtime_error("METIS could not order the nodes");
  std::vector<int> result(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) result[k] = nodes[static_cast<std::size_t>(order[k])];
  return result;
}

SupernodalStructure analyseSupernodes(const SparseLower& matrix, const std::vector<std::int64_t>& order) {
  Common common;
  cholmod_sparse view = patternOf(matrix);
  std::vector<SuiteSparse_long> given(order.begin(), order.end());
  cholmod_factor* factor = cholmod_l_analyze_p(&view, given.data(), nullptr, 0, &common.state);
  common.check();
  if (factor == nullptr || factor->is_super == 0) {
    cholmod_l_free_factor(&factor, &common.state);
    throw std::runtime_error("CHOLMOD could not analyse the stiffness matrix");
  }
  SupernodalStructure structure{.super = numbers(factor->super, factor->nsuper + 1),
                                .rowsBegin = numbers(factor->pi, factor->nsuper + 1),
                                .valuesBegin = numbers(factor->px, factor->nsuper + 1),
                                .rows = numbers(factor->s, factor->ssize),
                                .order = numbers(factor->Perm, factor->n),
                                .parents = {}};
  cholmod_l_free_factor(&factor, &common.state);
  std::vector<int> supernodeOf(order.size());
  for (std::size_t s = 0; s + 1 < structure.super.size(); ++s)
    for (std::int64_t j = structure.super[s]; j < structure.super[s + 1]; ++j)
      supernodeOf[static_cast<std::size_t>(j)] = static_cast<int>(s);
  for (std::size_t s = 0; s + 1 < structure.super.size(); ++s) {
    const auto below = static_cast<std::size_t>(structure.rowsBegin[s] + structure.width(s));
    const bool root = static_cast<std::int64_t>(below) == structure.rowsBegin[s + 1];
    structure.parents.push_back(root ? -1 : supernodeOf[static_cast<std::size_t>(structure.rows[below])]);
  }
  return structure;
}

}  // namespace falciform

#endif
