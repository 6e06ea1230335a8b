// The phantom experiment of thesis ch. III, rebuilt: counts, gold standard and what a registration makes of
// it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Modules/CommandLine/PhantomExperiment.h"

namespace falciform {
namespace {

using commandline::PhantomExperiment;

struct Counts {
  double points, falciform, ridge;
};

void expectCounts(const char* what, const Surface& surface, const Counts& thesis) {
  const auto within = [&](double found, double wanted) {
    EXPECT_NEAR(found, wanted, 0.1 * wanted) << what;  // 10 %
  };
  within(static_cast<double>(surface.size()), thesis.points);
  within(static_cast<double>(pointsOfPatch(surface, patch::kFalciform).size()), thesis.falciform);
  within(static_cast<double>(pointsOfPatch(surface, patch::kInferiorRidge).size()), thesis.ridge);
}

TEST(PhantomExperiment, HasTheThesissCountsAndRegistersAsWellAsItsGoldStandard) {
  const PhantomExperiment done = commandline::makePhantomExperiment(thesisPhantom());
  expectCounts("CT surface", done.preop, {106661, 2066, 1393});
  expectCounts("whole scan", done.made.scan, {34546, 1125, 404});
  expectCounts("sub-region", done.made.subRegion, {12376, 802, 303});

  EXPECT_LT(done.sphereErrorCtMm.maxCoeff(), 0.1);  // mm: asked for; a hundredth of a voxel is found
  EXPECT_LT(done.sphereErrorScanMm.maxCoeff(),
            0.1);  // mm: asked for; noise 0.51 mm over 700 points gives 0.04
  EXPECT_LT(done.goldTargetErrorMm.maxCoeff(), 0.05);  // mm: three times what the localisation error predicts
  // FRE alone predicts the gold standard's error: seven spheres have 21 - 6 degrees of freedom, so FRE itself
  // is uncertain by a fifth, and the one error drawn here by as much as its size.
  EXPECT_GT(done.goldTargetErrorMm.mean(), 0.2 * done.predictedTargetErrorMm.mean());
  EXPECT_LT(done.goldTargetErrorMm.mean(), 3 * done.predictedTargetErrorMm.mean());

  // The CT's patches are the points within 3 mm of the scan's, by the gold standard.
  const Points back = transformed(done.made.scan.points, done.gold.targetFromSource.inverse());
  std::vector<int> painted = pointsOfPatch(done.made.scan, patch::kFalciform);
  const std::vector<int> ridge = pointsOfPatch(done.made.scan, patch::kInferiorRidge);
  painted.insert(painted.end(), ridge.begin(), ridge.end());
  const KdTree tree(back, painted);
  for (Index i = 0; i < done.preop.size(); ++i) {
    const double away =
        std::sqrt(tree.nearest(Vector3d(done.preop.points.row(i).transpose())).squaredDistance);
    if (std::abs(away - 3) < 1e-9) continue;
    ASSERT_EQ(done.preop.patchAt(i) > 0, away < 3);
  }

  const RegistrationResult whole = registerSurfaces(done.preop, done.made.scan, {});
  const double error = commandline::phantomTargetErrors(done.made, whole.scanFromPreop).mean();
  RecordProperty("whole_scan_target_error_mm", std::to_string(error));
  EXPECT_LT(error, done.goldTargetErrorMm.mean() + 0.1);  // mm: the bound
  const RegistrationResult part = registerSurfaces(done.preop, done.made.subRegion, {});
  const double partError = commandline::phantomTargetErrors(done.made, part.scanFromPreop).mean();
  RecordProperty("subregion_target_error_mm", std::to_string(partError));
  EXPECT_LT(partError, 0.5);  // mm: a third of the points, on a ninth of the surface
}

}  // namespace
}  // namespace falciform
