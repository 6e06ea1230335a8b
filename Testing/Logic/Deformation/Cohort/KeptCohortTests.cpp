// The correlations of Docs/CohortTables.md, as `falciform cohort` wrote them for nine livers of known groups.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "Logic/Core/Draws.h"
#include "Logic/Deformation/Cohort/CohortAnalysis.h"

namespace falciform::test {
namespace {

std::vector<std::vector<std::string>> rowsOf(const std::string& name) {
  std::ifstream file(std::string(FALCIFORM_SOURCE_DIR) + "/Testing/Data/Cohort/" + name);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// `metric`: signed_distance or true_displacement.
Cohort kept(const std::string& metric) {
  const auto matrix = rowsOf(metric + ".csv"), groups = rowsOf("groups.csv");
  Cohort cohort;
  cohort.cases.assign(matrix.at(0).begin() + 1, matrix.at(0).end());
  const auto n = static_cast<Index>(cohort.cases.size());
  cohort.correlation.resize(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      cohort.correlation(i, j) =
          std::stod(matrix.at(static_cast<std::size_t>(i) + 1).at(static_cast<std::size_t>(j) + 1));
  cohort.groups = {"A", "B", "C"};
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    const auto& row = groups.at(i + 1);
    EXPECT_EQ(row.at(0), cohort.cases[i]);
    const auto found =
        row.size() < 2 ? cohort.groups.end() : std::find(cohort.groups.begin(), cohort.groups.end(), row[1]);
    cohort.groupOf.push_back(found == cohort.groups.end() ? -1
                                                          : static_cast<int>(found - cohort.groups.begin()));
  }
  return cohort;
}

TEST(KeptCohort, GroupsOfTheTruthAreMoreAlikeAndTheMeasurementFindsThem) {
  for (const char* metric : {"true_displacement", "signed_distance"}) {
    SCOPED_TRACE(metric);
    const Cohort cohort = kept(metric);
    ASSERT_EQ(cohort.cases.size(), 9u);
    const CohortAnalysis analysis = analyseCohort(cohort);
    for (const GroupComparison& group : analysis.groups) EXPECT_GT(group.difference(), 0);
    EXPECT_TRUE(analysis.all.permutation.exact);
    EXPECT_LT(analysis.all.permutation.pGreater, 0.05);
  }
}

TEST(KeptCohort, ShuffledGroupsAreFoundAsRarelyAsTheTestSays) {
  constexpr int kSeeds = 100;
  Cohort cohort = kept("signed_distance");
  const std::vector<int> groups = cohort.groupOf;
  int found = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    cohort.groupOf = groups;
    Draws draws(static_cast<std::uint64_t>(seed), 2);
    for (std::size_t k = groups.size() - 1; k > 0; --k)
      std::swap(cohort.groupOf[k],
                cohort.groupOf[static_cast<std::size_t>(draws.uniform() * static_cast<double>(k + 1))]);
    found += compareAllGroups(cohort).permutation.pGreater < 0.05;
  }
  // 5 of 100 expected, standard deviation 2.2: more than 13 happen once in 2000 times, none once in 170, if
  // the test is honest.
  EXPECT_LE(found, 13);
  EXPECT_GE(found, 1);
  RecordProperty("shuffled_found", found);
}

}  // namespace
}  // namespace falciform::test
