#include "Modules/Distributed/DistributedSolves.h"

#include <chrono>
#include <iomanip>
#include <optional>
#include <sstream>

namespace falciform::distributed {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// The setup's supports, what is pushed by 1 mm, as constraints; the same on every rank.
std::vector<NodeConstraint> constraintsOf(const Ranks& ranks, const AtlasJob& job, const AtlasSetup& setup) {
  std::vector<NodeConstraint> constraints;
  ranks.together([&] {
    const BoundaryFaces faces = boundaryFaces(job.mesh);
    std::vector<Support> supports = setup.supports;
    if (setup.pushed >= 0) supports[static_cast<std::size_t>(setup.pushed)].pushMm = 1;
    constraints = nodeConstraints(faces, nodeNormals(faces, job.mesh.nodes()), supports);
    if (ranks.first()) checkHeld(job.mesh, constraints, faces, supports);
  });
  return constraints;
}

}  // namespace

void solveTogether(const Ranks& ranks, const AtlasJob& job, const std::vector<int>& batches,
                   const IterationPlan& plan, const std::function<void(int, std::vector<Points>)>& done,
                   const std::function<void(const std::string&)>& told) {
  const NodeShares shares = shareNodes(job.mesh.points, ranks.size());
  std::optional<DistributedSolver> solver;
  int prepared = -1;
  for (const int batch : batches) {
    std::vector<Points> fields;
    const auto [first, last] = job.solves.batches[static_cast<std::size_t>(batch)];
    for (int number = first; number < last; ++number) {
      const AtlasSolves::Solve& solve = job.solves.solves[static_cast<std::size_t>(number)];
      const AtlasSetup& setup = job.members.setups[static_cast<std::size_t>(solve.setup)];
      const std::vector<Material> materials = materialsOf(job.design, setup.stiffnessRatio);
      const auto began = Clock::now();
      if (solve.setup != prepared) {
        solver.reset();  // before the next one takes its memory
        solver.emplace(ranks, job.mesh, shares, materials, constraintsOf(ranks, job, setup), plan);
        prepared = solve.setup;
      }
      const double preparedS = secondsSince(began);
      const auto solving = Clock::now();
      Points field =
          solver->solve(weightForces(job.mesh, materials, solve.load.tail<3>().transpose()), solve.load[0]);
      std::ostringstream line;
      line << "solve " << number + 1 << " of " << job.solves.solves.size() << ": " << solver->iterations()
           << " iterations, prepared in " << std::fixed << std::setprecision(2) << preparedS
           << " s, solved in " << secondsSince(solving) << " s";
      if (told && ranks.first()) told(line.str());
      if (ranks.first()) fields.push_back(std::move(field));
    }
    ranks.together([&] {
      if (ranks.first()) done(batch, std::move(fields));
    });
  }
}

}  // namespace falciform::distributed
