#include "Logic/Atlas/AtlasSolves.h"

#include <algorithm>
#include <memory>
#include <set>

#include "Logic/Atlas/IndependentLoads.h"
#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/SupportSolver.h"

namespace falciform {
namespace {

/// Few enough that a build can be shared out and stopped without losing much; enough that a pass over the
/// factor serves several.
constexpr int kBatch = 5;

double ratioOf(const AtlasMembers& members, int setup) {
  return members.setups[static_cast<std::size_t>(setup)].stiffnessRatio;
}

std::vector<Support> supportsUnder(const AtlasSetup& setup, double pushMm) {
  std::vector<Support> supports = setup.supports;
  if (setup.pushed >= 0) supports[static_cast<std::size_t>(setup.pushed)].pushMm = pushMm;
  return supports;
}

/// Everything but what is pushed.
std::vector<Support> heldBy(const AtlasSetup& setup) {
  std::vector<Support> held = setup.supports;
  if (setup.pushed >= 0) held.erase(held.begin() + setup.pushed);
  return held;
}

bool sameSupports(const std::vector<Support>& a, const std::vector<Support>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Support& one, const Support& other) {
    return one.kind == other.kind && one.faces == other.faces;
  });
}

/// All that any of the setups holds or pushes. Where they differ by what is pushed alone, the rest is held
/// always: that is eliminated once, and leaves small systems.
CandidateSupports candidatesOf(const std::vector<const AtlasSetup*>& setups) {
  CandidateSupports candidates;
  const std::vector<Support> held = heldBy(*setups.front());
  const bool alike = std::all_of(setups.begin(), setups.end(), [&](const AtlasSetup* setup) {
    return setup->pushed >= 0 && sameSupports(heldBy(*setup), held);
  });
  if (alike) candidates.held = held;
  std::set<int> fixed, sliding;
  for (const AtlasSetup* setup : setups)
    for (const Support& support : setup->supports)
      if (!alike || support.kind == SupportKind::Pushed)
        (support.kind == SupportKind::Fixed ? fixed : sliding)
            .insert(support.faces.begin(), support.faces.end());
  candidates.fixed.assign(fixed.begin(), fixed.end());
  candidates.sliding.assign(sliding.begin(), sliding.end());
  return candidates;
}

/// Answers for the solves of one stiffness.
using Solver = std::function<std::vector<Points>(const std::vector<AtlasSolves::Solve>&)>;

Solver oneSetup(const TetrahedralMesh& mesh, const std::vector<Material>& materials, const AtlasSetup& setup,
                const Progress& progress) {
  const BoundaryFaces faces = boundaryFaces(mesh);
  const std::vector<Support> supports = supportsUnder(setup, 1);
  std::vector<NodeConstraint> constraints =
      nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), supports);
  checkHeld(mesh, constraints, faces, supports);
  const auto held =
      std::make_shared<ConstrainedStiffness>(assembleStiffness(mesh, materials, progress.part(0, 0.1)),
                                             std::move(constraints), progress.part(0.1, 1));
  return [&mesh, materials, held](const std::vector<AtlasSolves::Solve>& wanted) {
    std::vector<Points> forces;
    std::vector<double> pushes;
    for (const AtlasSolves::Solve& solve : wanted) {
      forces.push_back(weightForces(mesh, materials, solve.load.tail<3>().transpose()));
      pushes.push_back(solve.load[0]);
    }
    return held->solve(forces, pushes);
  };
}

Solver manySetups(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                  const AtlasMembers& members, const CandidateSupports& candidates,
                  const Progress& progress) {
  const SupportSolver solver(mesh, materials, candidates, progress);
  return [&members, solver,
          heldAlways = !candidates.held.empty()](const std::vector<AtlasSolves::Solve>& wanted) {
    std::vector<SupportHypothesis> hypotheses;
    for (const AtlasSolves::Solve& solve : wanted) {
      const AtlasSetup& setup = members.setups[static_cast<std::size_t>(solve.setup)];
      std::vector<Support> supports = supportsUnder(setup, solve.load[0]);
      if (heldAlways) supports = {supports[static_cast<std::size_t>(setup.pushed)]};
      hypotheses.push_back(
          {.supports = std::move(supports), .gravityChangeMPerS2 = solve.load.tail<3>().transpose()});
    }
    return solver.solve(hypotheses);
  };
}

Solver solverOf(const TetrahedralMesh& mesh, const AtlasDesign& design, const AtlasMembers& members,
                double ratio, const Progress& progress) {
  const std::vector<Material> materials = materialsOf(design, ratio);
  std::vector<const AtlasSetup*> setups;
  for (const AtlasSetup& setup : members.setups)
    if (setup.stiffnessRatio == ratio) setups.push_back(&setup);
  if (setups.size() == 1) return oneSetup(mesh, materials, *setups.front(), progress);
  return manySetups(mesh, materials, members, candidatesOf(setups), progress);
}

}  // namespace

AtlasSolves planSolves(const AtlasMembers& all) {
  AtlasSolves result;
  const auto count = static_cast<Index>(all.members.size());
  struct Entry {
    Index member, solve;
    double value;
  };
  std::vector<Entry> entries;
  for (Index first = 0, last = 0; first < count; first = last) {
    const int setup = all.members[static_cast<std::size_t>(first)].setup;
    while (last < count && all.members[static_cast<std::size_t>(last)].setup == setup) ++last;
    Eigen::MatrixXd loads(last - first, 4);
    for (Index m = first; m < last; ++m)
      loads.row(m - first) = all.members[static_cast<std::size_t>(m)].load();
    const IndependentLoads independent = independentLoads(loads);
    for (Index k = 0; k < independent.basis.rows(); ++k) {
      for (Index m = first; m < last; ++m)
        entries.push_back(
            {m, static_cast<Index>(result.solves.size()), independent.coefficients(m - first, k)});
      result.solves.push_back({.setup = setup, .load = independent.basis.row(k)});
    }
  }
  const auto solves = static_cast<int>(result.solves.size());
  result.combinations = Eigen::MatrixXd::Zero(count, solves);
  for (const Entry& entry : entries) result.combinations(entry.member, entry.solve) = entry.value;
  for (int first = 0, last = 0; first < solves; first = last) {
    const double ratio = ratioOf(all, result.solves[static_cast<std::size_t>(first)].setup);
    while (last < solves && last < first + kBatch &&
           ratioOf(all, result.solves[static_cast<std::size_t>(last)].setup) == ratio)
      ++last;
    result.batches.push_back({first, last});
  }
  return result;
}

void solveBatches(const TetrahedralMesh& mesh, const AtlasDesign& design, const AtlasMembers& members,
                  const AtlasSolves& solves, const std::vector<int>& batches,
                  const std::function<void(int, std::vector<Points>)>& done, const Progress& progress) {
  const auto ratioOfBatch = [&](int batch) {
    const int first = solves.batches[static_cast<std::size_t>(batch)].first;
    return ratioOf(members, solves.solves[static_cast<std::size_t>(first)].setup);
  };
  Solver solver;
  const double step = 1.0 / std::max<double>(1, static_cast<double>(batches.size()));
  for (std::size_t k = 0; k < batches.size(); ++k) {
    const Progress part = progress.part(static_cast<double>(k) * step, static_cast<double>(k + 1) * step);
    const double ratio = ratioOfBatch(batches[k]);
    if (k == 0 || ratioOfBatch(batches[k - 1]) != ratio) {
      solver = nullptr;  // before the next one takes its memory
      solver = solverOf(mesh, design, members, ratio, part.part(0, 0.9));
    }
    part.report(0.9, "Solving");
    const AtlasSolves::Batch& batch = solves.batches[static_cast<std::size_t>(batches[k])];
    done(batches[k], solver({solves.solves.begin() + batch.first, solves.solves.begin() + batch.last}));
  }
  progress.report(1, "Solved");
}

}  // namespace falciform
