#include "Logic/Registration/MethodDispatch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Registration/Dirr.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::partialScan;
using test::placedApart;
using test::randomMotion;
using testing::Contains;
using testing::HasSubstr;

class OtherMethods : public testing::TestWithParam<RegistrationMethod> {
 protected:
  OtherMethods() {
    body.colours = Colours::Constant(body.size(), 3, 100);
    scan = partialScan(lumpyBody(5), Vector3d(0.1, -0.6, 0.8), 75, 4, truth, 0.3);
    scan.colours = Colours::Constant(scan.size(), 3, 100);
    settings.method = GetParam();
  }
  Surface body = lumpyBody(4), scan;
  Isometry3d truth = randomMotion(6, 300);
  RegistrationSettings settings;
};

TEST_P(OtherMethods, StartFromPatchesWhereBothSidesHaveThem) {
  const RegistrationResult result = registerSurfaces(body, scan, settings);
  // From any pose to the right basin; the scan's points are no vertices, edges are 6 mm, samples sparser.
  EXPECT_LT(placedApart(body.points, result.scanFromPreop, truth), 10);
  EXPECT_FALSE(result.history.empty());
}

TEST_P(OtherMethods, StartFromTheOneGivenElse) {
  settings.start = RegistrationStart::Given;
  const Isometry3d near = truth * Eigen::Translation3d(4, -3, 5);
  const RegistrationResult result = registerSurfaces(body, scan, settings, near);
  EXPECT_LT(placedApart(body.points, result.scanFromPreop, truth), 10);
  EXPECT_LT(result.translationMm, 15);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("only if the start is near")));
}

TEST_P(OtherMethods, AWarpIsToldAndOnlyOfTheNonRigid) {
  settings.start = RegistrationStart::Given;
  const RegistrationResult result = registerSurfaces(body, scan, settings, truth);
  const bool nonRigid = GetParam() == RegistrationMethod::Tps || GetParam() == RegistrationMethod::Rpm;
  ASSERT_EQ(result.warp.has_value(), nonRigid);
  if (!nonRigid) return;
  EXPECT_THAT(result.warnings, Contains(HasSubstr("not rigid")));
  EXPECT_EQ(result.warp->scanFromPreop(body.points), result.warp->preopOnScan);
  EXPECT_LT(
      (result.warp->preopOnScan - transformed(body.points, result.scanFromPreop)).rowwise().norm().mean(), 3);
}

std::string nameOf(const testing::TestParamInfo<RegistrationMethod>& info) {
  return enumToString(info.param);
}

INSTANTIATE_TEST_SUITE_P(All, OtherMethods,
                         testing::Values(RegistrationMethod::Dirr, RegistrationMethod::Cpt,
                                         RegistrationMethod::Colour, RegistrationMethod::Tps,
                                         RegistrationMethod::Rpm),
                         nameOf);

TEST(MethodDispatch, TheDoorIsTheFunction) {
  const Surface body = lumpyBody(3);
  const Surface scan = partialScan(body, Vector3d(0, 0, 1), 75, 1, randomMotion(2));
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Dirr;
  settings.start = RegistrationStart::Given;
  settings.maxIterations = 3;
  const Isometry3d start = randomMotion(2) * Eigen::Translation3d(3, 2, 1);
  EXPECT_EQ(
      registerSurfaces(body, scan, settings, start).scanFromPreop.matrix(),
      registerDirr(PreparedPreop(body), scan, settings, start.inverse()).preopFromScan.inverse().matrix());
}

TEST(MethodDispatch, KnowsWhichMethodsAreItsOwn) {
  for (const std::string_view name : enumNames(RegistrationMethod{})) {
    const auto method = enumFromString<RegistrationMethod>("method", name);
    EXPECT_EQ(isOtherMethod(method), name != "icp" && name != "wgf" && name != "picp" && name != "auto")
        << name;
    EXPECT_EQ(enumToString(method), name);
  }
}

}  // namespace
}  // namespace falciform
