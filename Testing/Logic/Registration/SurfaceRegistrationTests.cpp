#include "Logic/Registration/SurfaceRegistration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/RegistrationFigures.h"
#include "Logic/Registration/RegistrationLogic.h"
#include "Testing/Logic/Registration/PartialScan.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::partialScan;
using test::placedApart;
using test::randomMotion;
using testing::HasSubstr;

const Vector3d kView(0.1, -0.6, 0.8);

TEST(SurfaceRegistration, FindsThePoseFromAnyStartUnderNoise) {
  const Surface body = lumpyBody(5);
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Isometry3d truth = randomMotion(seed, 300);
    const Surface scan = partialScan(body, kView, 60, 3, truth, 0.5, seed);
    const RegistrationResult result = registerSurfaces(body, scan, {});
    EXPECT_TRUE(result.converged);
    // Closest vertices 3 mm apart lock the scan within about an edge; the far side of the body swings out.
    EXPECT_LT(placedApart(body.points, result.scanFromPreop, truth), 6) << "seed " << seed;
  }
}

TEST(SurfaceRegistration, OnePatchIsEnoughOnARigidBody) {
  const Surface body = lumpyBody(5);
  RegistrationSettings settings;
  settings.patches = {patch::kInferiorRidge};
  for (unsigned seed = 20; seed < 26; ++seed) {
    const Isometry3d truth = randomMotion(seed, 300);
    const RegistrationResult result =
        registerSurfaces(body, partialScan(body, kView, 80, 3, truth), settings);
    // The right basin, as near as closest vertices 3 mm apart come; the next basin is more than 60 mm away.
    EXPECT_LT(placedApart(body.points, result.scanFromPreop, truth), 12) << "seed " << seed;
  }
}

TEST(SurfaceRegistration, CommonMotionOfBothSidesChangesNothing) {
  const Surface body = lumpyBody(4);
  const Isometry3d truth = randomMotion(1), common = randomMotion(2, 200);
  const Surface scan = partialScan(body, kView, 60, 1, truth, 0.5);
  const RegistrationResult here = registerSurfaces(body, scan, {});
  const RegistrationResult there =
      registerSurfaces(transformed(body, common, "LPS"), transformed(scan, common, "scanner"), {});
  // Both stop when nothing moves by 0.02 mm; the grid of rotations meets the body turned, so only the minimum
  // is shared.
  EXPECT_LT(placedApart(body.points, there.scanFromPreop, common * here.scanFromPreop * common.inverse()),
            0.05);
  EXPECT_NEAR(here.rmsMm, there.rmsMm, 1e-3);
}

TEST(SurfaceRegistration, SwappingTheSidesInvertsThePose) {
  const Surface body = lumpyBody(4);
  const Isometry3d truth = randomMotion(9);
  const Surface moved = transformed(body, truth, "scanner");
  const RegistrationResult forth = registerSurfaces(body, moved, {}),
                           back = registerSurfaces(moved, body, {});
  // Both stop when nothing moves by 0.02 mm, a step of a fit that converges tenfold each time.
  EXPECT_LT(placedApart(body.points, back.scanFromPreop * forth.scanFromPreop, Isometry3d::Identity()),
            0.002);
}

TEST(SurfaceRegistration, SameBitsForAnyNumberOfThreads) {
  const Surface body = lumpyBody(5);
  const Surface scan = partialScan(body, kView, 60, 1, randomMotion(5), 1.0);
  setThreads(1);
  const RegistrationResult one = registerSurfaces(body, scan, {});
  for (const int count : {2, 5}) {
    setThreads(count);
    const RegistrationResult many = registerSurfaces(body, scan, {});
    EXPECT_EQ(one.scanFromPreop.matrix(), many.scanFromPreop.matrix());
    EXPECT_EQ(one.iterations, many.iterations);
    EXPECT_EQ(one.rmsMm, many.rmsMm);
  }
  setThreads(0);
}

TEST(SurfaceRegistration, FiguresAreThoseOfTheReportedPose) {
  const Surface body = lumpyBody(4);
  const Surface scan = partialScan(body, kView, 60, 1, randomMotion(5), 1.0);
  const RegistrationResult result = registerSurfaces(body, scan, {});
  const Points moved = transformed(scan.points, result.scanFromPreop.inverse());
  double squared = 0;
  for (Index i = 0; i < moved.rows(); ++i)
    squared += (body.points.rowwise() - moved.row(i)).rowwise().squaredNorm().minCoeff();
  EXPECT_NEAR(result.rmsMm, std::sqrt(squared / static_cast<double>(moved.rows())), 1e-9);
  EXPECT_EQ(result.patchRmsMm.size(), 2u);
  EXPECT_GT(result.coverage, 0.1);
  EXPECT_LT(result.coverage, 0.5);
  EXPECT_FALSE(result.history.empty());
  EXPECT_EQ(result.basins.front().scanFromPreop.matrix(), result.scanFromPreop.matrix());
}

TEST(SurfaceRegistration, WarnsWhenItShouldNotBeTrusted) {
  const Surface body = lumpyBody(4);
  Surface scan = partialScan(body, kView, 60, 1, randomMotion(5));
  scan.points *= 1.4;  // not the same organ
  EXPECT_THAT(registerSurfaces(body, scan, {}).warnings, testing::Contains(HasSubstr("RMS residual")));
  RegistrationSettings icp;
  icp.method = RegistrationMethod::Icp;
  EXPECT_THAT(registerSurfaces(body, scan, icp).warnings,
              testing::Contains(HasSubstr("no patches were used")));
}

TEST(SurfaceRegistration, WarnsOfAnExpectedErrorThatOftenIsAFailure) {
  const Surface body = lumpyBody(3);
  RegistrationSettings bare;
  bare.method = RegistrationMethod::Auto;
  RegistrationResult result;
  result.converged = true;
  result.coverage = 0.3;
  result.expectedErrorMeanMm = 2.9;
  EXPECT_THAT(registrationWarnings(result, body, body, bare), testing::IsEmpty());
  result.expectedErrorMeanMm = 3.1;
  EXPECT_THAT(registrationWarnings(result, body, body, bare),
              testing::ElementsAre(HasSubstr("expected target error is 3.1 mm")));
}

TEST(SurfaceRegistration, RefusesBadInputInOneLine) {
  const Surface body = lumpyBody(2);
  Surface two = body;
  two.points.conservativeResize(2, 3);
  two.triangles.resize(0, 3);
  two.patch.resize(2);
  EXPECT_THROW((void)registerSurfaces(body, two, {}), InputError);
  Surface broken = body;
  broken.points(3, 1) = std::nan("");
  EXPECT_THROW((void)registerSurfaces(broken, body, {}), InputError);
  RegistrationSettings missing;
  missing.patches = {7};
  try {
    (void)registerSurfaces(body, body, missing);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("patch 7"));
    EXPECT_THAT(e.what(), HasSubstr("pre-op surface"));
  }
  RegistrationSettings upside;
  upside.weightMax = 2;
  upside.weightBase = 50;
  EXPECT_THROW((void)registerSurfaces(body, body, upside), InputError);
}

TEST(RegistrationLogic, SaysWhatIsMissingThenRunsIntoTheCase) {
  Case document;
  RegistrationLogic logic(document);
  EXPECT_THAT(logic.missingInput(), HasSubstr("surface"));
  EXPECT_THROW((void)logic.run(), InputError);
  const Surface body = lumpyBody(3);
  document.setPreop(std::make_shared<const Surface>(body));
  EXPECT_THAT(logic.missingInput(), HasSubstr("scan"));
  const Isometry3d truth = randomMotion(8);
  document.setScan(std::make_shared<const Surface>(partialScan(body, kView, 70, 1, truth)));
  EXPECT_EQ(logic.missingInput(), "");
  int seen = 0;
  logic.observer = [&](const IterationRecord&) { ++seen; };
  const RegistrationResult& result = logic.run();
  EXPECT_LT(placedApart(body.points, result.scanFromPreop, truth), 24);  // mm: edges are 12 mm here
  EXPECT_EQ(seen, result.iterations);
  EXPECT_EQ(document.registration().get(), &result);
}

TEST(RegistrationLogic, LandmarksGiveTheStart) {
  Case document;
  const Surface body = lumpyBody(4);
  const Isometry3d truth = randomMotion(8, 300);
  document.setPreop(std::make_shared<const Surface>(body));
  document.setScan(std::make_shared<const Surface>(partialScan(body, kView, 70, 1, truth)));
  Landmarks from, to;
  for (const int i : {0, 40, 500, 900}) {
    from.points.push_back({"L" + std::to_string(i), body.points.row(i).transpose()});
    to.points.push_back({"L" + std::to_string(i), truth * from.points.back().position + Vector3d(2, -1, 1)});
  }
  document.setPreopLandmarks(from);
  document.setScanLandmarks(to);
  RegistrationLogic logic(document);
  logic.settings.method = RegistrationMethod::Icp;
  logic.startFromLandmarks = true;
  EXPECT_LT(placedApart(body.points, logic.run().scanFromPreop, truth),
            12);  // mm, as above: edges are 6 mm here
}

}  // namespace
}  // namespace falciform
