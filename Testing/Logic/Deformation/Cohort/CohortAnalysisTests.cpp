#include "Logic/Deformation/Cohort/CohortAnalysis.h"

#include <gmock/gmock.h>

#include <cmath>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two groups of two that are alike, one case of its own.
Cohort smallCohort() {
  Cohort cohort;
  cohort.cases = {"p", "q", "r", "s", "t"};
  cohort.groups = {"left", "right"};
  cohort.groupOf = {0, 1, 0, 1, -1};
  cohort.correlation.resize(5, 5);
  cohort.correlation << 1, -0.1, 0.8, 0.2, 0.5,  //
      -0.1, 1, 0.1, 0.7, 0.6,                    //
      0.8, 0.1, 1, 0.3, 0.0,                     //
      0.2, 0.7, 0.3, 1, 0.2,                     //
      0.5, 0.6, 0.0, 0.2, 1;
  return cohort;
}

TEST(CohortAnalysis, SaysOfEachCaseWhichGroupItIsMostAlike) {
  const CohortAnalysis analysis = analyseCohort(smallCohort());
  EXPECT_DOUBLE_EQ(analysis.likeness(0, 0), 0.8);   // p with r alone, itself apart
  EXPECT_DOUBLE_EQ(analysis.likeness(0, 1), 0.05);  // p with q and s
  EXPECT_DOUBLE_EQ(analysis.likeness(4, 0), 0.25);
  EXPECT_DOUBLE_EQ(analysis.likeness(4, 1), 0.4);
  EXPECT_THAT(analysis.mostAlike, ElementsAre(0, 1, 0, 1, 1));
}

TEST(CohortAnalysis, LeavingOutACaseIsAnalysingTheRest) {
  const Cohort cohort = smallCohort();
  const CohortAnalysis analysis = analyseCohort(cohort);
  ASSERT_EQ(analysis.leaveOneOut.size(), 5u);
  const Cohort rest = withoutCase(cohort, 4);
  EXPECT_THAT(rest.cases, ElementsAre("p", "q", "r", "s"));
  EXPECT_EQ(rest.correlation(1, 3), 0.7);
  const CohortAnalysis alone = analyseCohort(rest);
  EXPECT_EQ(analysis.leaveOneOut[4].all.permutation.pGreater, alone.all.permutation.pGreater);
  EXPECT_EQ(analysis.leaveOneOut[4].groups[1].outGroup.mean, alone.groups[1].outGroup.mean);
  // Without p the left group has no pair any more.
  EXPECT_EQ(analysis.leaveOneOut[0].groups[0].inGroup.count, 0);
  EXPECT_EQ(analysis.leaveOneOut[0].groups[1].inGroup.count, 1);
}

TEST(CohortAnalysis, WarnsWhereNoResultCouldBeSignificant) {
  Cohort cohort = smallCohort();
  EXPECT_THAT(analyseCohort(cohort).warnings,
              ElementsAre(HasSubstr("'left' has 2 of 5 cases, in 10 arrangements"), HasSubstr("'right'")));
  cohort.groups.push_back("both");
  cohort.groupOf[4] = 2;
  const CohortAnalysis analysis = analyseCohort(cohort);
  ASSERT_EQ(analysis.warnings.size(), 3u);
  EXPECT_THAT(analysis.warnings[2], HasSubstr("'both' has one case"));
  EXPECT_TRUE(std::isnan(analysis.likeness(4, 2)));
}

TEST(CohortAnalysis, RefusesWhatIsNoCohortInWords) {
  const auto refused = [](const Cohort& cohort, const std::string& mention) {
    try {
      (void)analyseCohort(cohort);
      FAIL() << "accepted: " << mention;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(mention));
    }
  };
  Cohort cohort = smallCohort();
  cohort.correlation(1, 3) = 0.6;
  refused(cohort, "cases 'q' and 's' is 0.6 above the diagonal and 0.7 below");
  cohort = smallCohort();
  cohort.correlation(0, 2) = cohort.correlation(2, 0) = 1.5;
  refused(cohort, "1.5; give a number from -1 to 1");
  cohort.correlation(0, 2) = cohort.correlation(2, 0) = std::nan("");
  refused(cohort, "give a number from -1 to 1");
  cohort = smallCohort();
  cohort.groupOf = {0, 1, -1, -1, -1};
  refused(cohort, "no group has two cases");
  cohort.groupOf = {1, 1, 1, 1, 1};
  refused(cohort, "all cases are of one group");
  cohort.groupOf.pop_back();
  refused(cohort, "4 of 5 cases have a group");
  cohort = smallCohort();
  cohort.correlation.conservativeResize(4, 4);
  refused(cohort, "4 x 4 for 5 cases");
  cohort.cases.resize(2);
  refused(cohort, "2 cases");
}

}  // namespace
}  // namespace falciform
