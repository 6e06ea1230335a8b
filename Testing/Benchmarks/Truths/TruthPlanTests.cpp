#include <gtest/gtest.h>

#include <numbers>

#include "Testing/Benchmarks/Truths/TruthPlan.h"

namespace falciform::bench {
namespace {

constexpr std::array kLobes{PackedLobe::Left, PackedLobe::Right, PackedLobe::Both};

TEST(TruthPlan, IsAFunctionOfSeedAndLobe) {
  for (const PackedLobe lobe : kLobes) {
    EXPECT_EQ(toJson(drawTruth(7, lobe)), toJson(drawTruth(7, lobe)));
    EXPECT_NE(toJson(drawTruth(7, lobe)), toJson(drawTruth(8, lobe)));
  }
}

TEST(TruthPlan, PacksTheLobeItIsAskedTo) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const TruthPlan left = drawTruth(seed, PackedLobe::Left), right = drawTruth(seed, PackedLobe::Right),
                    both = drawTruth(seed, PackedLobe::Both);
    EXPECT_EQ(right.packs[0].pushMm, 0);
    EXPECT_EQ(left.packs[1].pushMm, 0);
    // The same seed packs the same towel, whether or not there is another: streams do not run into each
    // other.
    EXPECT_EQ(both.packs[0].pushMm, left.packs[0].pushMm);
    EXPECT_EQ(both.packs[1].pushMm, right.packs[1].pushMm);
    EXPECT_NE(both.packs[0].pushMm, both.packs[1].pushMm);
    EXPECT_EQ(left.liverKPa, right.liverKPa);
  }
}

TEST(TruthPlan, GravityKeepsItsLengthAndTurnsByTheAngle) {
  const Vector3d before(0, 9.81, 0);  // to the back: supine, LPS
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const TruthPlan plan = drawTruth(seed, PackedLobe::Both);
    const Vector3d after = before + plan.gravityChangeMPerS2;
    EXPECT_NEAR(after.norm(), 9.81, 1e-12);
    const double turned = std::acos(after.dot(before) / (9.81 * 9.81)) * 180 / std::numbers::pi;
    EXPECT_NEAR(turned, plan.turnDeg, 1e-6);  // degrees: acos's rounding at small angles
  }
}

TEST(TruthPlan, DrawsFromTheWholeOfEachRangeAndNotBeyond) {
  struct Range {
    const char* name;
    double low, high;
  };
  // As Docs/HeldOutTruths.md says.
  const std::vector<Range> ranges{{"liver_kpa", 4, 12},
                                  {"poissons_ratio", 0.45, 0.47},
                                  {"tumour_factor", 5, 10},
                                  {"tumour_radius_mm", 8, 20},
                                  {"gravity_turn_deg", 10, 50},
                                  {"held_radius_mm", 30, 60},
                                  {"coverage_aimed_at", 0.18, 0.4},
                                  {"scanner_distance_mm", 400, 600}};
  constexpr int kDraws = 400;
  for (const Range& range : ranges) {
    double least = 1e9, most = -1e9;
    for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
      const double value = toJson(drawTruth(seed, PackedLobe::Left)).at(range.name).get<double>();
      least = std::min(least, value);
      most = std::max(most, value);
    }
    EXPECT_GE(least, range.low) << range.name;
    EXPECT_LE(most, range.high) << range.name;
    // 400 even draws leave a tenth of the range at either end empty once in 10^18.
    EXPECT_LT(least, range.low + 0.1 * (range.high - range.low)) << range.name;
    EXPECT_GT(most, range.high - 0.1 * (range.high - range.low)) << range.name;
  }
}

}  // namespace
}  // namespace falciform::bench
