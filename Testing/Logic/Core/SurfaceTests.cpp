#include "Logic/Core/Surface.h"

#include <gmock/gmock.h>

#include <limits>

#include "Logic/Core/Errors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Surface painted() {
  Surface s = test::sphere(10, 1, {1, 2, 3});
  s.normals = (s.points.rowwise() - Vector3d(1, 2, 3).transpose()) / 10;
  s.patch.assign(static_cast<std::size_t>(s.size()), patch::kNone);
  s.patch[4] = patch::kFalciform;
  s.patch[7] = s.patch[2] = 5;
  s.patchNames[5] = "notch";
  s.arrays["signed_distance_mm"] = VectorXd::LinSpaced(s.size(), -1, 1);
  return s;
}

std::string refusal(const Surface& surface) {
  try {
    checkSurface(surface, "scan.ply");
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

}  // namespace

TEST(Surface, ARigidMotionKeepsDistancesTurnsNormalsAndLeavesTheRest) {
  const Surface before = painted();
  const Isometry3d motion = test::randomMotion(11);
  const Surface after = transformed(before, motion, "scanner");
  EXPECT_EQ(after.frame, "scanner");
  EXPECT_EQ(before.frame, "LPS");
  for (Index i = 0; i < before.size(); ++i) {
    // Coordinates of some 200 mm: a few units in the last place.
    EXPECT_LT((after.points.row(i).transpose() - motion * before.points.row(i).transpose()).norm(), 1e-12);
    EXPECT_LT((after.normals.row(i).transpose() - motion.linear() * before.normals.row(i).transpose()).norm(),
              1e-14);
  }
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.patch, before.patch);
  EXPECT_EQ(after.arrays.at("signed_distance_mm"), before.arrays.at("signed_distance_mm"));
  EXPECT_EQ(after.patchNames, before.patchNames);
}

TEST(Surface, AMotionAndItsInverseCancel) {
  const Surface before = painted();
  const Isometry3d motion = test::randomMotion(12);
  const Surface back = transformed(transformed(before, motion, "scanner"), motion.inverse(), "LPS");
  EXPECT_LT((back.points - before.points).cwiseAbs().maxCoeff(), 1e-12);  // mm, rounding at 200 mm
  EXPECT_LT((back.normals - before.normals).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(transformed(before.points, Isometry3d::Identity()), before.points);
}

TEST(Surface, PatchesAreFoundAndNamed) {
  const Surface s = painted();
  EXPECT_EQ(pointsOfPatch(s, 5), (std::vector<int>{2, 7}));
  EXPECT_EQ(patchLabels(s), (std::vector<int>{1, 5}));
  EXPECT_EQ(patchName(s, 5), "notch");
  EXPECT_EQ(patchName(s, patch::kFalciform), "falciform");
  EXPECT_EQ(patchName(s, patch::kInferiorRidge), "inferior ridge");
  EXPECT_EQ(patchName(s, 9), "patch 9");
  const Surface bare = test::box({1, 1, 1});
  EXPECT_EQ(bare.patchAt(3), patch::kNone);
  EXPECT_TRUE(patchLabels(bare).empty());
  EXPECT_EQ(static_cast<Index>(pointsOfPatch(bare, patch::kNone).size()), bare.size());
}

TEST(Surface, ASoundSurfaceAndACloudPassTheCheck) {
  EXPECT_NO_THROW(checkSurface(painted(), "liver"));
  Surface cloud = painted();
  cloud.triangles.resize(0, 3);
  EXPECT_NO_THROW(checkSurface(cloud, "cloud"));
  EXPECT_NO_THROW(checkSurface({}, "empty"));
}

TEST(Surface, DamageIsRefusedByNameAndValue) {
  const auto damaged = [](auto damage) {
    Surface s = painted();
    damage(s);
    return refusal(s);
  };
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THAT(damaged([&](Surface& s) { s.points(3, 1) = bad; }),
                AllOf(HasSubstr("scan.ply"), HasSubstr("finite")));
  EXPECT_THAT(damaged([](Surface& s) { s.triangles(0, 0) = static_cast<int>(s.size()); }),
              HasSubstr("triangle"));
  EXPECT_THAT(damaged([](Surface& s) { s.triangles(5, 2) = -1; }), HasSubstr("triangle"));
  EXPECT_THAT(damaged([](Surface& s) { s.patch.pop_back(); }), HasSubstr("'Patch' has 41 values for 42"));
  EXPECT_THAT(damaged([](Surface& s) { s.normals.conservativeResize(5, 3); }), HasSubstr("Normals"));
  EXPECT_THAT(damaged([](Surface& s) { s.colours.setZero(5, 3); }), HasSubstr("RGB"));
  EXPECT_THAT(damaged([](Surface& s) { s.arrays["depth_mm"] = VectorXd::Zero(5); }), HasSubstr("depth_mm"));
  EXPECT_THAT(damaged([](Surface& s) { s.patch[0] = 256; }), HasSubstr("256"));
  EXPECT_THAT(damaged([](Surface& s) { s.patch[0] = -1; }), HasSubstr("-1"));
}

}  // namespace falciform
