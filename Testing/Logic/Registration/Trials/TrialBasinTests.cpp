#include "Logic/Registration/Trials/TrialBasins.h"

#include <gmock/gmock.h>

#include "Logic/Registration/PointRegistration.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TrialRecord ended(const Isometry3d& error, double rmsMm) {
  TrialRecord record;
  record.error = error;
  record.rmsMm = rmsMm;
  return record;
}

TEST(OutermostPoints, TellHowFarAMotionMovesTheWholeBody) {
  const Points all = test::lumpyBody(4).points, few = outermostPoints(all);
  ASSERT_LE(few.rows(), 256);
  for (unsigned seed = 1; seed <= 50; ++seed) {
    Isometry3d motion = test::randomMotion(seed, 5);
    motion.linear() = Eigen::AngleAxisd(0.05, Eigen::AngleAxisd(motion.linear()).axis()).toRotationMatrix();
    const double whole = targetErrors(all, all, motion).maxCoeff(),
                 found = targetErrors(few, few, motion).maxCoeff();
    EXPECT_LE(found, whole);
    // 256 directions lie within 0.13 rad of any hull normal of interest: 1 % of the way.
    EXPECT_GT(found, 0.98 * whole) << seed;
  }
}

TEST(TrialBasins, PosesWithinTheLimitAreOneAndTheCommonestIsTheFirst) {
  const Points corners = outermostPoints(test::lumpyBody(3).points);
  const auto shifted = [](double x) { return Isometry3d(Eigen::Translation3d(x, 0, 0)); };
  const Isometry3d turned(Eigen::AngleAxisd(EIGEN_PI, Vector3d::UnitY()));
  const std::vector<TrialRecord> records{
      ended(turned, 9),        ended(shifted(0), 1),  ended(shifted(4.9), 2), ended(shifted(60), 3),
      ended(shifted(-4.9), 2), ended(shifted(61), 4), ended(shifted(0.1), 5)};
  EXPECT_THAT(trialBasins(records, corners, 5), testing::ElementsAre(3, 1, 1, 2, 1, 2, 1));
}

TEST(TrialBasins, AStrayPoseBesideATightGroupDoesNotCutItInTwo) {
  const Points corners = outermostPoints(test::lumpyBody(3).points);
  std::vector<TrialRecord> records{
      ended(Isometry3d(Eigen::Translation3d(5, 0, 0)), 3)};  // comes first, fits worst
  for (int i = 0; i < 10; ++i)
    records.push_back(ended(Isometry3d(Eigen::Translation3d(0.1 * i - 0.5, 0, 0)), 1 + 0.01 * i));
  const std::vector<int> basins = trialBasins(records, corners, 5);
  for (std::size_t i = 1; i < basins.size(); ++i) EXPECT_EQ(basins[i], 1);
}

TEST(TrialBasins, NothingHasNone) {
  EXPECT_TRUE(trialBasins({}, outermostPoints(test::sphere(50, 1).points), 5).empty());
}

}  // namespace
}  // namespace falciform
