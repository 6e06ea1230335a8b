#include "Logic/Registration/Trials/GoldStandard.h"

#include <gmock/gmock.h>

#include "Logic/Core/Errors.h"
#include "Testing/Logic/Registration/Trials/SmallTrial.h"

namespace falciform {
namespace {

using test::placedApart;
using test::SmallTrial;
using testing::HasSubstr;

TEST(GoldStandard, AGivenTransformWins) {
  const SmallTrial small;
  const Isometry3d given = Eigen::Translation3d(3, 0, 0) * small.scanFromPreop;
  const GoldStandard gold = goldStandard(small.preop, small.scan, small.targets, given);
  EXPECT_EQ(gold.scanFromPreop.matrix(), given.matrix());
  EXPECT_NEAR(gold.targetErrorMm, 3, 1e-9);
  EXPECT_GT(gold.rmsMm, 0.5);  // a shift of 3 mm shows
}

TEST(GoldStandard, TargetsAreFittedAndItsFiguresAreThoseOfThatPose) {
  const SmallTrial small;
  const GoldStandard gold = goldStandard(small.preop, small.scan, small.targets, {});
  EXPECT_LT(placedApart(small.body.points, gold.scanFromPreop, small.scanFromPreop), 1e-9);
  EXPECT_THAT(gold.source, HasSubstr("4 targets"));
  EXPECT_LT(gold.rmsMm, 1e-9);
  EXPECT_LT(gold.targetErrorMm, 1e-9);
}

TEST(GoldStandard, WithoutEnoughTargetsThePatchesGiveIt) {
  const SmallTrial small;
  TrialTargets line;  // any turn about the line fits as well
  line.preop.resize(3, 3);
  line.preop << 0, 0, 0, 10, 0, 0, 20, 0, 0;
  line.scan = transformed(line.preop, small.scanFromPreop);
  for (const TrialTargets& targets : {TrialTargets{}, line}) {
    const GoldStandard gold = goldStandard(small.preop, small.scan, targets, {});
    // An exact part of the surface; the stop rule leaves 1e-3 mm of motion.
    EXPECT_LT(placedApart(small.body.points, gold.scanFromPreop, small.scanFromPreop), 0.1);
    EXPECT_THAT(gold.source, HasSubstr("falciform and inferior ridge"));
    EXPECT_EQ(std::isnan(gold.targetErrorMm), targets.preop.rows() == 0);
  }
}

TEST(GoldStandard, WithNothingToRestOnThereIsNone) {
  SmallTrial small;
  small.scan.patch.clear();
  EXPECT_THROW((void)goldStandard(small.preop, small.scan, {}, {}), InputError);
}

}  // namespace
}  // namespace falciform
