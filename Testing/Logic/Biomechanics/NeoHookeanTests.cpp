// The programs that make held-out truths rest on CalculiX in large displacement: its input is written rightly
// if it meets closed forms in which shear modulus, bulk modulus, density and gravity all show.
#include <gtest/gtest.h>

#include "Testing/Support/TemporaryFolder.h"
#include "Testing/Verification/NeoHookeanBar.h"

namespace falciform::verification {
namespace {

constexpr Material kLiver{.youngsModulusMPa = 0.006, .poissonsRatio = 0.46, .densityKgPerM3 = 1060};

/// The largest distance between CalculiX and the closed form, in the end's displacement.
double errorShare(BarLoad kind, double load, double& endMm, int layers = 8) {
  const test::TemporaryFolder folder;
  const SharedProblem bar = neoHookeanBar(kLiver, kind, load, layers);
  const Points found = solveWithCalculix(bar, *findCalculix(), folder.path());
  double worst = 0;
  for (Index n = 0; n < found.rows(); ++n) {
    const Vector3d place = bar.body.mesh.points.row(n).transpose();
    const BarMotion motion = neoHookeanBarMotion(kLiver, kind, load, place.x());
    const Vector3d wanted(motion.alongMm, motion.widening * place.y(), motion.widening * place.z());
    worst = std::max(worst, (found.row(n).transpose() - wanted).norm());
  }
  endMm = neoHookeanBarMotion(kLiver, kind, load, kBarLengthMm).alongMm;
  return worst / std::abs(endMm);
}

TEST(NeoHookeanBar, ClosedFormIsHookesForSmallStretch) {
  // A millionth of Young's modulus: what is left of second order is about a millionth as well.
  const double load = 1e-6 * kLiver.youngsModulusMPa;
  const BarMotion motion = neoHookeanBarMotion(kLiver, BarLoad::EndTraction, load, kBarLengthMm);
  EXPECT_NEAR(motion.alongMm / kBarLengthMm / 1e-6, 1, 1e-5);
  EXPECT_NEAR(motion.widening / 1e-6, -kLiver.poissonsRatio, 1e-5);
}

TEST(NeoHookeanBar, CalculixMeetsTheClosedFormOfAStretch) {
  if (!findCalculix()) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  for (const double share : {0.5, -0.4}) {  // of Young's modulus: well beyond where Hooke's law holds
    double endMm = 0;
    // The state is even, so quadratic elements hold it exactly: what is left is where CalculiX ends its
    // iterations, a residual of half a hundredth of the load before the last, quadratic step.
    EXPECT_LT(errorShare(BarLoad::EndTraction, share * kLiver.youngsModulusMPa, endMm), 2e-4) << share;
    EXPECT_GT(std::abs(endMm), 0.25 * kBarLengthMm) << share;
  }
}

TEST(NeoHookeanBar, CalculixMeetsTheClosedFormUnderItsOwnWeight) {
  if (!findCalculix()) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  double endMm = 0;
  // 40 g press the bar by 28 % and its foot by half; 5 mm layers bend the closed form's curve by a twenty-
  // thousandth of that.
  EXPECT_LT(errorShare(BarLoad::OwnWeightConfined, 40 * 9.81, endMm), 1e-4);
  EXPECT_LT(endMm, -0.25 * kBarLengthMm);
}

TEST(NeoHookeanBar, WhatIsLeftUnderACrushingWeightIsTheElements) {
  if (!findCalculix()) GTEST_SKIP() << "CalculiX is not installed (Debian: calculix-ccx)";
  // Under 200 g the foot is pressed to a tenth within a layer. Were weight, density or bulk modulus said
  // wrongly, finer layers would not help.
  double endMm = 0;
  const double coarse = errorShare(BarLoad::OwnWeightConfined, 200 * 9.81, endMm, 4),
               fine = errorShare(BarLoad::OwnWeightConfined, 200 * 9.81, endMm, 8);
  EXPECT_LT(fine, coarse / 4);  // quadratic elements: an eighth, if the state were smooth on their scale
  EXPECT_LT(endMm, -0.6 * kBarLengthMm);
}

}  // namespace
}  // namespace falciform::verification
