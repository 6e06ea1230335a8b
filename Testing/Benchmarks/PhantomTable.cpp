// Prints the tables of Docs/UserGuide/Phantom.md: the counts of the virtual phantom beside the thesis's, how
// well its spheres are located, its gold standard, and what registrations make of it.   ./run bench phantom

#include <cstdio>

#include "Logic/Core/LandmarkPairs.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Modules/CommandLine/PhantomExperiment.h"

namespace falciform {
namespace {

using commandline::PhantomExperiment;
using commandline::phantomTargetErrors;

void printCounts(const char* what, const Surface& surface, const char* thesis) {
  std::printf("| %s | %ld | %zu | %zu | %s |\n", what, static_cast<long>(surface.size()),
              pointsOfPatch(surface, patch::kFalciform).size(),
              pointsOfPatch(surface, patch::kInferiorRidge).size(), thesis);
}

struct Method {
  const char* name;
  RegistrationSettings settings;
  bool fromGold = false;
};

std::vector<Method> methods() {
  Method both{.name = "default, both patches", .settings = {}},
      one{.name = "default, falciform", .settings = {}}, none{.name = "auto, no patches", .settings = {}};
  one.settings.patches = {patch::kFalciform};
  none.settings.method = RegistrationMethod::Auto;
  Method picp2{"thesis-phantom PICP2, from the gold standard", registrationPreset("thesis-phantom"), true};
  Method icp{"thesis ICP, from the gold standard", registrationPreset("thesis-phantom"), true};
  icp.settings.method = RegistrationMethod::Icp;
  return {both, one, none, picp2, icp};
}

void printRegistrations(const PhantomExperiment& done) {
  const PreparedPreop preop(done.preop);
  const Isometry3d& gold = done.gold.targetFromSource;
  std::puts(
      "| registration | scan | target error mean | largest | from the gold standard, mean | RMS residual |");
  std::puts("|---|---|---|---|---|---|");
  const VectorXd& own = done.goldTargetErrorMm;
  std::printf("| gold standard: seven spheres | | %.3f | %.3f | 0 | |\n", own.mean(), own.maxCoeff());
  for (const Method& method : methods())
    for (const auto& [name, scan] :
         {std::pair("whole", &done.made.scan), {"sub-region", &done.made.subRegion}}) {
      const RegistrationResult result =
          registerSurfaces(preop, *scan, method.settings, method.fromGold ? gold : Isometry3d::Identity());
      const VectorXd error = phantomTargetErrors(done.made, result.scanFromPreop);
      double apart = 0;
      for (const Landmark& target : done.made.targets.points)
        apart += (result.scanFromPreop * target.position - gold * target.position).norm() /
                 static_cast<double>(done.made.targets.points.size());
      std::printf("| %s | %s | %.3f | %.3f | %.3f | %.3f |\n", method.name, name, error.mean(),
                  error.maxCoeff(), apart, result.rmsMm);
      std::fflush(stdout);
    }
}

void append(VectorXd& all, const Landmarks& found, const Landmarks& truth) {
  const Points there = positionsOf(found), places = positionsOf(truth);
  const Index first = all.size();
  all.conservativeResize(first + places.rows());
  for (Index i = 0; i < places.rows(); ++i)
    all[first + i] = (there.rowwise() - places.row(i)).rowwise().norm().minCoeff();
}

/// Spheres and beads of five phantoms, at the thesis's noise: in a clean room and in a busy one.
void printMarkers() {
  constexpr int kSeeds = 5;
  std::puts("| located, mm | markers | mean | largest |\n|---|---|---|---|");
  VectorXd ballsCt, beads, clean, busy;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    PhantomPlan plan = thesisPhantom();
    plan.liver.edgeLengthMm = 2;  // of what is scanned; the CT keeps the thesis's voxels
    plan.phantom.beads = 43;
    plan.phantom.seed = plan.scanner.seed = plan.faults.faultSeed = seed;
    const PhantomCase quiet = makePhantomCase(plan);
    append(ballsCt, quiet.spheresCt, quiet.trueSpheresCt);
    append(beads, quiet.beadsCt, quiet.targets);
    append(clean, quiet.spheresScan, quiet.trueSpheresScan);
    plan.faults = {.baselineMm = 100,
                   .noiseGrowsWithRange = true,
                   .dropout = 0.3,
                   .smoke = 0.01,
                   .instruments = 2,
                   .drape = false,
                   .photograph = false,
                   .faultSeed = seed};
    plan.liver.voxelMm = 4;  // the CT is not looked at again
    plan.phantom.beads = 0;
    const PhantomCase spoilt = makePhantomCase(plan);
    append(busy, spoilt.spheresScan, spoilt.trueSpheresScan);
  }
  const auto row = [](const char* what, const VectorXd& mm) {
    std::printf("| %s | %ld | %.3f | %.3f |\n", what, static_cast<long>(mm.size()), mm.mean(), mm.maxCoeff());
  };
  row("spheres in the CT, clicked at", ballsCt);
  row("steel beads of 1 mm in the CT, without clicks", beads);
  row("spheres in the scan", clean);
  row("spheres in the scan: shadows, lost rays, 1 % smoke, 2 rods", busy);
}

}  // namespace
}  // namespace falciform

int main() {
  using namespace falciform;
  const PhantomExperiment done = commandline::makePhantomExperiment(thesisPhantom());
  std::puts("| points | here | falciform | inferior ridge | thesis |\n|---|---|---|---|---|");
  printCounts("CT surface", done.preop, "106,661 / 2,066 / 1,393");
  printCounts("whole scan", done.made.scan, "34,546 / 1,125 / 404");
  printCounts("sub-region", done.made.subRegion, "12,376 / 802 / 303");
  std::puts("\n| mm | mean | largest |\n|---|---|---|");
  const auto row = [](const char* what, const VectorXd& mm) {
    std::printf("| %s | %.3f | %.3f |\n", what, mm.mean(), mm.maxCoeff());
  };
  row("spheres in the CT: region growing, centroid", done.sphereErrorCtMm);
  row("spheres in the scan: least squares", done.sphereErrorScanMm);
  row("residual of the point registration (FRE)", done.gold.freByPointMm);
  row("target error of the gold standard", done.goldTargetErrorMm);
  row("target error expected from FRE", done.predictedTargetErrorMm);
  std::printf("\nFRE %.3f mm (root mean square; thesis 1.4 mm)\n\n", done.gold.freMm);
  printRegistrations(done);
  std::puts("");
  printMarkers();
}
