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

TEST(UpdateCases, PatchStartsFindTheLiverAndTheRestIsWarnedOf) {
  FALCIFORM_NEEDS_DATA("update");
  int good = 0, cases = 0;
  for (const std::string& name : test::updateCaseNames()) {
    const UpdateCase c = test::readUpdateCase(name);
    const RegistrationResult result = registerSurfaces(c.preop, c.scan, {});
    const double error = targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean();
    RecordProperty(name + "_target_error_mm", std::to_string(error));
    ++cases;
    if (error < 1.4 * c.optimalRigidMm + 1) {
      ++good;
    } else {
      EXPECT_FALSE(result.warnings.empty()) << name << " is off by " << error << " mm and nothing is said";
    }
  }
  EXPECT_GE(good, cases - 1);
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
            0.3);  // mm: both stop when no point moves 1e-3 mm a step
}

}  // namespace
}  // namespace falciform
