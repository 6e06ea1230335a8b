#include "Testing/Benchmarks/Truths/CohortPlan.h"

#include <gtest/gtest.h>

#include <map>

namespace falciform::bench {
namespace {

/// The mean over many seeds, so that what is each patient's own averages out.
double meanAt(Procedure procedure, double u, double v) {
  constexpr int kSeeds = 400;
  double sum = 0;
  for (int seed = 0; seed < kSeeds; ++seed)
    sum += drawCohortCase(procedure, static_cast<std::uint64_t>(seed)).front->at(u, v);
  return sum / kSeeds;
}

TEST(CohortPlan, IsAFunctionOfProcedureAndSeed) {
  for (const Procedure procedure : {Procedure::Bilobar, Procedure::HeadUp}) {
    EXPECT_EQ(toJson(drawCohortCase(procedure, 7)), toJson(drawCohortCase(procedure, 7)));
    EXPECT_NE(toJson(drawCohortCase(procedure, 7)), toJson(drawCohortCase(procedure, 8)));
  }
}

TEST(CohortPlan, GroupsAAndCAreFlattenedAtTheirOwnPlacesAndBIsMoreCurved) {
  using enum Procedure;
  // Forwards above 0, mm; u from the right end, -1, over the falciform ligament to the left end, 1.
  EXPECT_LT(meanAt(LeftHepatectomy, 0.15, 0), -5);
  EXPECT_GT(meanAt(LeftHepatectomy, -0.9, 0), 2);
  EXPECT_LT(meanAt(RightLobe, -0.5, 0), -5);
  EXPECT_GT(meanAt(RightLobe, 0.6, 0), 2);
  EXPECT_GT(meanAt(Bilobar, -0.15, 0), 5);
  EXPECT_LT(meanAt(Bilobar, -1, 0.8), -2);
  EXPECT_LT(meanAt(Bilobar, 1, 0), -2);
  // The deepest place is farther left in A than in C.
  EXPECT_LT(meanAt(LeftHepatectomy, 0.15, 0), meanAt(RightLobe, 0.15, 0) - 4);
}

TEST(CohortPlan, TenLiversAreThreeTwoThreeAndTwoOfTheirOwn) {
  std::map<std::string, int> groups;
  std::map<int, int> livers;
  for (const CohortMember& member : cohortMembers()) {
    ++groups[groupOf(member.procedure)];
    ++livers[member.liver];
    EXPECT_EQ(drawCohortCase(member.procedure, 1).front.has_value(), !groupOf(member.procedure).empty());
  }
  EXPECT_EQ(groups, (std::map<std::string, int>{{"", 2}, {"A", 3}, {"B", 2}, {"C", 3}}));
  EXPECT_EQ(livers.size(), 10u);
}

TEST(CohortPlan, TurningTheTableKeepsTheLengthOfGravity) {
  const Vector3d before(0, 9.81, 0);  // the patient on the back: posterior is +y
  for (const CohortMember& member : cohortMembers())
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      EXPECT_NEAR((before + drawCohortCase(member.procedure, seed).gravityChangeMPerS2).norm(), 9.81, 1e-9);
}

}  // namespace
}  // namespace falciform::bench
