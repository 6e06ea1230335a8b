// The tables of Docs/Verification.md, each worked out here and now: bench-verification.
#include <cmath>
#include <cstdio>
#include <string>

#include "Logic/Biomechanics/BlasKernel.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Testing/Verification/Cantilever.h"
#include "Testing/Verification/PackedBlock.h"
#include "Testing/Verification/PatchTest.h"
#include "Testing/Verification/SharedProblems.h"
#include "Testing/Verification/SlidingBed.h"
#include "Testing/Verification/SmoothField.h"
#include "Testing/Verification/ThickSphere.h"

using namespace falciform;
using namespace falciform::verification;

namespace {

const char* nameOf(bool quadratic) { return quadratic ? "T10" : "T4"; }

void patchTable() {
  std::printf("| element | patch test: largest error, of the largest displacement |\n|---|---|\n");
  for (const bool quadratic : {false, true})
    std::printf("| %s | %.1e |\n", nameOf(quadratic), patchTestError(quadratic));
}

void orderTable(double nu) {
  std::printf(
      "\n| smooth field, nu = %.2f | boxes a side | error in L2 | order | error in energy | order |\n", nu);
  std::printf("|---|---|---|---|---|---|\n");
  const Material material{.youngsModulusMPa = 0.015, .poissonsRatio = nu};
  for (const bool quadratic : {false, true}) {
    FieldError before;
    int coarse = 0;
    for (const int cells : quadratic ? std::vector<int>{2, 4, 8, 12} : std::vector<int>{4, 8, 16, 24}) {
      const FieldError error = smoothFieldError(material, quadratic, cells);
      std::printf("| %s | %d | %.3e | ", nameOf(quadratic), cells, error.displacement);
      if (coarse > 0)
        std::printf("%.2f", observedOrder(before.displacement, error.displacement, coarse, cells));
      std::printf(" | %.3e | ", error.energy);
      if (coarse > 0) std::printf("%.2f", observedOrder(before.energy, error.energy, coarse, cells));
      std::printf(" |\n");
      before = error;
      coarse = cells;
    }
  }
}

void cantileverTable() {
  std::printf(
      "\n| cantilever: sag by Timoshenko's beam | boxes through the depth | nodes | own weight, nu = 0 | end "
      "shear, nu = 0 | own weight, nu = 0.3 | end shear, nu = 0.3 |\n|---|---|---|---|---|---|---|\n");
  for (const bool quadratic : {false, true})
    for (const int cells : quadratic ? std::vector<int>{1, 2, 4} : std::vector<int>{1, 2, 4, 8}) {
      std::string figures;
      Index nodes = 0;
      for (const double nu : {0.0, 0.3})
        for (const CantileverLoad load : {CantileverLoad::OwnWeight, CantileverLoad::EndShear}) {
          const HeldBody bar = cantilever(nu, quadratic, cells, load);
          nodes = bar.mesh.nodes();
          char text[32];
          std::snprintf(text, sizeof text, " %.4f |",
                        endSagMm(bar, solve(bar).displacements) / timoshenkoSagMm(nu, load));
          figures += text;
        }
      std::printf("| %s | %d | %ld |%s\n", nameOf(quadratic), cells, static_cast<long>(nodes),
                  figures.c_str());
    }
}

void sphereTable() {
  std::printf(
      "\n| thick sphere under pressure | nu | layers | nodes | growth of the hollow, error, %% | largest "
      "difference to Lame's field, %% |\n|---|---|---|---|---|---|\n");
  for (const bool quadratic : {false, true})
    for (const double nu : {0.3, 0.47})
      for (const int layers : {4, 8, 16}) {
        const Material material{.youngsModulusMPa = 0.015, .poissonsRatio = nu};
        const HeldBody sphere = thickSphere(material, quadratic, layers);
        const SphereErrors errors = sphereErrors(sphere, solve(sphere).displacements);
        std::printf("| %s | %.2f | %d | %ld | %+.2f | %.2f |\n", nameOf(quadratic), nu, layers,
                    static_cast<long>(sphere.mesh.nodes()), 100 * errors.swell, 100 * errors.worst);
      }
}

void lockingTable(BlockLoad load) {
  struct Mesh {
    bool quadratic;
    double boxMm;
  };
  constexpr Mesh kReference{true, 25.0 / 3};
  std::string head = load == BlockLoad::OwnWeight ? "\n| block under its weight: nu |"
                                                  : "\n| packed block: nu |",
              rule = "\n|---|";
  const std::vector<Mesh> meshes{{false, 25}, {false, 12.5}, {true, 25}, {false, 6.25}, {true, 12.5}};
  for (const Mesh& mesh : meshes) {
    char text[64];
    const HeldBody block = packedBlock(0.3, mesh.quadratic, mesh.boxMm, load);
    std::snprintf(text, sizeof text, " %s, %.4g mm, %ld nodes |", nameOf(mesh.quadratic), mesh.boxMm,
                  static_cast<long>(block.mesh.nodes()));
    head += text;
    rule += "---|";
  }
  std::printf("%s%s\n", head.c_str(), rule.c_str());
  for (const double nu : {0.3, 0.4, 0.45, 0.47, 0.49, 0.495}) {
    const double reference =
        blockStiffness(packedBlock(nu, kReference.quadratic, kReference.boxMm, load), load);
    std::printf("| %.3g |", nu);
    for (const Mesh& mesh : meshes)
      std::printf(
          " %+.1f |",
          100 * (blockStiffness(packedBlock(nu, mesh.quadratic, mesh.boxMm, load), load) / reference - 1));
    std::printf("\n");
    std::fflush(stdout);
  }
}

void bedTable() {
  std::printf(
      "\n| sliding bed, tilted | element | rotated problem against rotated answer | into the bed | force "
      "along "
      "the bed | balance of forces |\n|---|---|---|---|---|---|\n");
  for (const bool wavy : {false, true})
    for (const bool quadratic : {false, true}) {
      const BedErrors e = bedErrors(quadratic, wavy);
      std::printf("| %s | %s | %.1e | %.1e | %.1e | %.1e |\n", wavy ? "curved" : "plane", nameOf(quadratic),
                  e.rotated, e.intoBed, e.tangentialForce, e.balance);
    }
}

void calculixTable() {
  const auto calculix = findCalculix();
  if (!calculix) {
    std::printf("\nCalculiX is not installed (Debian: calculix-ccx): no comparison.\n");
    return;
  }
  std::printf(
      "\n| against CalculiX | element | nodes | largest displacement, mm | largest difference, of that |\n"
      "|---|---|---|---|---|\n");
  const test::TemporaryFolder folder;
  for (const bool quadratic : {false, true})
    for (const SharedProblem& problem : sharedProblems(quadratic, 2)) {
      const Points theirs = solveWithCalculix(problem, *calculix, folder.path());
      const Points ours = solve(problem.body).displacements;
      std::printf("| %s | %s | %ld | %.4g | %.1e |\n", problem.name.c_str(), nameOf(quadratic),
                  static_cast<long>(problem.body.mesh.nodes()), largest(ours),
                  largest(ours - theirs) / largest(ours));
    }
}

}  // namespace

int main(int, char** argv) {
  restartWithBestBlasKernel(argv);
  patchTable();
  orderTable(0.3);
  orderTable(0.47);
  cantileverTable();
  sphereTable();
  lockingTable(BlockLoad::OwnWeight);
  lockingTable(BlockLoad::Packed);
  bedTable();
  calculixTable();
  return 0;
}
