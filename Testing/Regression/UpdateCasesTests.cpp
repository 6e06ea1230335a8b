// Rigid registration of the real livers in `update/`, from the pose as stored and nothing else. Prints the
// table that Docs/Registration.md shows:  ./run test -R UpdateCases -V

#include <gtest/gtest.h>

#include <cstdio>

#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

using test::UpdateCase;

RegistrationSettings icpFromTheStoredPose() {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.start = RegistrationStart::Given;
  return settings;
}

RegistrationSettings thesisFromTheStoredPose() { return registrationPreset("thesis-clinical"); }

RegistrationSettings withPatches(std::vector<int> patches) {
  RegistrationSettings settings;
  settings.patches = std::move(patches);
  return settings;
}

double meanTargetError(const UpdateCase& c, const RegistrationResult& result) {
  return targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean();
}

TEST(UpdateCases, PatchStartsFindTheLiverAndTheRestIsWarnedOf) {
  FALCIFORM_NEEDS_DATA("update");
  std::puts(
      "| case | coverage | optimal rigid | ICP, one start | thesis-clinical, one start | falciform | both "
      "patches | "
      "RMS, both | warnings, both |");
  std::puts("|---|---|---|---|---|---|---|---|---|");
  int good = 0, cases = 0;
  for (const std::string& name : test::updateCaseNames()) {
    const UpdateCase c = test::readUpdateCase(name);
    const RegistrationResult icp = registerSurfaces(c.preop, c.scan, icpFromTheStoredPose());
    const RegistrationResult thesis = registerSurfaces(c.preop, c.scan, thesisFromTheStoredPose());
    const RegistrationResult one = registerSurfaces(c.preop, c.scan, withPatches({patch::kFalciform}));
    const RegistrationResult both = registerSurfaces(c.preop, c.scan, withPatches({}));
    std::printf("| %s | %.0f %% | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %zu |\n", name.c_str(),
                100 * c.coverage, c.optimalRigidMm, meanTargetError(c, icp), meanTargetError(c, thesis),
                meanTargetError(c, one), meanTargetError(c, both), both.rmsMm, both.warnings.size());
    ++cases;
    if (meanTargetError(c, both) < 1.4 * c.optimalRigidMm + 1)
      ++good;
    else
      EXPECT_FALSE(both.warnings.empty()) << name << " is off and nothing is said";
  }
  std::puts("Mean target error, mm.");
  EXPECT_GE(good, cases - 1);
}

TEST(UpdateCases, ThePoseDoesNotDependOnTheStart) {
  FALCIFORM_NEEDS_DATA("update/ircad17_left");
  const UpdateCase c = test::readUpdateCase("ircad17_left");
  const RegistrationResult stored = registerSurfaces(c.preop, c.scan, {});
  Isometry3d turned = Isometry3d::Identity();
  turned.rotate(Eigen::AngleAxisd(2.5, Vector3d(1, -2, 0.5).normalized()));
  turned.translation() = Vector3d(150, -80, 200);
  Surface elsewhere = transformed(c.scan, turned, "scanner");
  const RegistrationResult moved = registerSurfaces(c.preop, elsewhere, {});
  const Points here = transformed(c.preop.points, turned * stored.scanFromPreop),
               there = transformed(c.preop.points, moved.scanFromPreop);
  EXPECT_LT((here - there).rowwise().norm().maxCoeff(),
            0.3);  // mm: both stop when no point moves 1e-3 mm a step
}

}  // namespace
}  // namespace falciform
