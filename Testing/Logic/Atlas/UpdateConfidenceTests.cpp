#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Atlas/UpdateConfidence.h"
#include "Logic/Core/Errors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

double shareOf(const std::vector<RegionExpectation>& regions) {
  double sum = 0;
  for (const RegionExpectation& region : regions) sum += region.areaShare;
  return sum;
}

TEST(UpdateConfidence, NamesTheSideOfTheLobeThatIsExpectedWorst) {
  Surface ball = sphere(60, 4);
  VectorXd expected = VectorXd::Ones(ball.size());
  // Patient LPS: the back of the right lobe is where x is low and y high.
  for (Index i = 0; i < ball.size(); ++i)
    if (ball.points(i, 0) < 0 && ball.points(i, 1) > 35) expected[i] = 6;
  const auto regions = expectationByRegion(ball, expected);
  ASSERT_FALSE(regions.empty());
  EXPECT_EQ(regions.front().name, "the back of the right lobe");
  EXPECT_GT(regions.front().meanMm, 3);
  EXPECT_LE(regions.front().meanMm, 6);
}

TEST(UpdateConfidence, AnEvenExpectationIsEvenInEveryRegionAndTheyCoverTheSurface) {
  const Surface ball = sphere(60, 4);
  const auto regions = expectationByRegion(ball, VectorXd::Constant(ball.size(), 2.5));
  for (const RegionExpectation& region : regions) EXPECT_NEAR(region.meanMm, 2.5, 1e-12) << region.name;
  // Of a ball parted at two thirds of its width nothing but the left lobe's right side is missing.
  EXPECT_GT(shareOf(regions), 0.97);
  EXPECT_LE(shareOf(regions), 1 + 1e-12);
}

TEST(UpdateConfidence, TheFalciformPatchPartsTheLobes) {
  Surface ball = sphere(60, 4);
  VectorXd expected = VectorXd::Ones(ball.size());
  for (Index i = 0; i < ball.size(); ++i)
    if (ball.points(i, 1) < -40 && ball.points(i, 0) > -20 && ball.points(i, 0) < 15) expected[i] = 9;
  EXPECT_EQ(expectationByRegion(ball, expected).front().name, "the front of the right lobe");
  ball.patch.assign(static_cast<std::size_t>(ball.size()), patch::kNone);
  for (Index i = 0; i < ball.size(); ++i)
    if (std::abs(ball.points(i, 0) + 25) < 4) ball.patch[static_cast<std::size_t>(i)] = patch::kFalciform;
  EXPECT_EQ(expectationByRegion(ball, expected).front().name, "the front of the left lobe");
}

TEST(UpdateConfidence, RefusesErrorsOfAnotherSurface) {
  EXPECT_THROW((void)expectationByRegion(sphere(10, 1), VectorXd::Ones(3)), InputError);
}

}  // namespace
}  // namespace falciform::test
