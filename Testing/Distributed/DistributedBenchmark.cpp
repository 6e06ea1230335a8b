// mpirun -n RANKS bench-distributed EDGE_MM [LOADS [direct]]: the packed built-in liver at one edge length,
// by PETSc over the ranks and, if asked, beside it by elimination on the first: one row of the table in
// Docs/Atlas.md.
#include <malloc.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Core/Parallel.h"
#include "Modules/Distributed/DistributedSolver.h"
#include "Testing/Distributed/PackedLiver.h"

namespace falciform {
namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// "VmRSS:" or "VmHWM:", bytes.
double memory(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == key) {
      status >> word;
      return 1024 * std::stod(word);
    }
  return 0;
}

/// From here on the peak counts anew.
double baseline() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  return memory("VmRSS:");
}

}  // namespace
}  // namespace falciform

int main(int count, char** values) {
  using namespace falciform;
  const distributed::Ranks ranks;
  if (count < 2) {
    if (ranks.first())
      std::fprintf(stderr, "usage: mpirun -n RANKS bench-distributed EDGE_MM [LOADS [direct]]\n");
    return 2;
  }
  const int loads = count > 2 ? std::atoi(values[2]) : 3;
  const test::PackedLiver liver(std::atof(values[1]));
  const auto unknowns = 3.0 * static_cast<double>(liver.mesh.nodes());
  setThreads(1);
  const distributed::NodeShares shares = distributed::shareNodes(liver.mesh.points, ranks.size());
  const auto forcesOf = [&](int load) {
    return weightForces(liver.mesh, liver.materials, Vector3d::Unit(load % 3) * 9.81);
  };
  Points found;
  {
    const double before = baseline(), began = seconds();
    distributed::DistributedSolver solver(ranks, liver.mesh, shares, liver.materials, liver.constraints);
    const double prepared = seconds();
    for (int load = 0; load < loads; ++load) found = solver.solve(forcesOf(load), 10);
    const double solved = seconds(), bytes = ranks.sum(memory("VmHWM:") - before),
                 matrix = solver.matrixBytes();
    const double complexity = solver.gridComplexity();
    if (ranks.first())
      std::printf(
          "petsc  ranks %d dof %.0f elements %ld: prepare %.2f s, solve %.2f s a load, %d iterations, "
          "%.0f B/dof (K %.0f, grids' entries %.2f of K's)\n",
          ranks.size(), unknowns, static_cast<long>(liver.mesh.size()), prepared - began,
          (solved - prepared) / loads, solver.iterations(), bytes / unknowns, matrix / unknowns, complexity);
  }
  if (ranks.first() && count > 3) {
    setThreads(ranks.size());
    const double before = baseline(), began = seconds();
    const ConstrainedStiffness direct(assembleStiffness(liver.mesh, liver.materials), liver.constraints);
    const double prepared = seconds();
    Points wanted;
    for (int load = 0; load < loads; ++load) wanted = direct.solve({forcesOf(load)}, {10}).front();
    const double solved = seconds();
    std::printf(
        "direct threads %d dof %.0f: factorise %.2f s, solve %.2f s a load, %.0f B/dof; difference %.1e\n",
        ranks.size(), unknowns, prepared - began, (solved - prepared) / loads,
        (memory("VmHWM:") - before) / unknowns,
        (found - wanted).rowwise().norm().maxCoeff() / wanted.rowwise().norm().maxCoeff());
  }
  return 0;
}
