// Rigid registration of the real livers in `update/`, from the pose as stored and nothing else.
// `./run bench update-cases` prints the table with the other methods beside it.

#include <gtest/gtest.h>

#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

using test::UpdateCase;

/// With two patches, one, and none: all within the bound of the best that a rigid motion can do.
TEST(UpdateCases, EveryLiverIsFoundWithPatchesOrNone) {
  FALCIFORM_NEEDS_DATA("update");
  RegistrationSettings one, none;
  one.patches = {patch::kFalciform};
  none.method = RegistrationMethod::Auto;
  for (const std::string& name : test::updateCaseNames()) {
    const UpdateCase c = test::readUpdateCase(name);
    const PreparedPreop preop(c.preop);
    for (const auto& [settings, what] : {std::pair(RegistrationSettings{}, "two patches"),
                                         std::pair(one, "falciform"), std::pair(none, "auto")}) {
      const RegistrationResult result = registerSurfaces(preop, c.scan, settings);
      const double error = targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean();
      RecordProperty(name + "_" + what + "_target_error_mm", std::to_string(error));
      EXPECT_LT(error, 1.4 * c.optimalRigidMm + 0.5) << name << ", " << what;
    }
  }
}

/// Mean expected beside mean true target error, truth unseen: half to twice over the seven together.
TEST(UpdateCases, WhatItExpectsIsAboutWhatIsTrue) {
  FALCIFORM_NEEDS_DATA("update");
  double expected = 0, error = 0;
  for (const std::string& name : test::updateCaseNames()) {
    const UpdateCase c = test::readUpdateCase(name);
    const RegistrationResult result = registerSurfaces(c.preop, c.scan, {});
    error += targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean();
    for (Index i = 0; i < c.targetsPreop.rows(); ++i)
      expected += result.expectedTargetErrorMm(c.targetsPreop.row(i).transpose()) /
                  static_cast<double>(c.targetsPreop.rows());
  }
  EXPECT_GT(expected, 0.5 * error);
  EXPECT_LT(expected, 2 * error);
}

TEST(UpdateCases, ThePoseDoesNotDependOnTheStart) {
  FALCIFORM_NEEDS_DATA("update/ircad17_left");
  const UpdateCase c = test::readUpdateCase("ircad17_left");
  const RegistrationResult stored = registerSurfaces(c.preop, c.scan, {});
  Isometry3d turned = Isometry3d::Identity();
  turned.rotate(Eigen::AngleAxisd(2.5, Vector3d(1, -2, 0.5).normalized()));
  turned.translation() = Vector3d(150, -80, 200);
  const RegistrationResult moved = registerSurfaces(c.preop, transformed(c.scan, turned, "scanner"), {});
  const Points here = transformed(c.preop.points, turned * stored.scanFromPreop);
  const Points there = transformed(c.preop.points, moved.scanFromPreop);
  EXPECT_LT((here - there).rowwise().norm().maxCoeff(),
            0.3);  // mm: both stop when the fit moves 0.02 mm a step
}

}  // namespace
}  // namespace falciform
