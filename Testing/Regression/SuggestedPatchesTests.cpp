#include <gtest/gtest.h>

#include "Testing/Regression/SuggestedPatches.h"
#include "Testing/Support/RealData.h"

namespace falciform::test {
namespace {

// What is suggested in place of a painted pre-op surface must lead to the same pose: the liver has bent, so
// that no rigid pose is right, and poses within 1.5 mm of each other at the targets are as good as each
// other.
constexpr double kAsGoodMm = 1.5;

TEST(SuggestedPatches, RegisterALiverAsItsAnnotatedPatchesDo) {
  FALCIFORM_NEEDS_DATA("update/ircad17_both");
  const UpdateCase c = readUpdateCase("ircad17_both");
  const double annotated = targetErrorMm(c, c.preop, c.scan);
  EXPECT_LT(targetErrorMm(c, suggestedPreop(c), dabbedScan(c, 1)), annotated + kAsGoodMm);
}

TEST(SuggestedPatches, RegisterALiverWithOneSidePackedAsItsAnnotatedPatchesDo) {
  FALCIFORM_NEEDS_DATA("update/ircad5_left");
  const UpdateCase c = readUpdateCase("ircad5_left");
  const double annotated = targetErrorMm(c, c.preop, c.scan);
  EXPECT_LT(targetErrorMm(c, suggestedPreop(c), dabbedScan(c, 1)), annotated + kAsGoodMm);
}

}  // namespace
}  // namespace falciform::test
