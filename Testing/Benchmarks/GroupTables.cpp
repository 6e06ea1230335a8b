// Prints the tables of Docs/UserGuide/Cohort.md: thesis Tables IV.5 and IV.6 as read, Table IV.7 as computed
// from them beside the thesis's, exact tests of the same, each case left out, and how often each test finds
// groups that mean nothing.   ./run bench group-tables

#include <cmath>
#include <cstdio>

#include "Logic/Deformation/Cohort/CohortAnalysis.h"
#include "Modules/CommandLine/CohortInput.h"
#include "Modules/CommandLine/CohortReport.h"
#include "Modules/CommandLine/Figures.h"
#include "Testing/Logic/Deformation/Cohort/RandomCohort.h"

namespace falciform {
namespace {

using commandline::fixed;
using commandline::meanAndSd;
using commandline::pText;

/// A half row of thesis Table IV.7.
struct PrintedRow {
  const char *in, *out, *p;
};

struct ThesisMetric {
  const char *name, *table, *file;
  PrintedRow rows[3];
};

constexpr ThesisMetric kMetrics[] = {{"signed distance",
                                      "IV.5",
                                      "TableIV5.csv",
                                      {{"0.23 ± 0.24", "-0.09 ± 0.32", "0.11"},
                                       {"0.35", "-0.11 ± 0.27", "N/A"},
                                       {"0.40 ± 0.08", "0.00 ± 0.37", "0.08"}}},
                                     {"curvature difference",
                                      "IV.6",
                                      "TableIV6.csv",
                                      {{"0.27 ± 0.13", "0.13 ± 0.14", "0.12"},
                                       {"0.07", "0.13 ± 0.16", "N/A"},
                                       {"0.04 ± 0.05", "0.10 ± 0.11", "0.37"}}}};

commandline::CohortInput readThesis(const char* file) {
  const std::string folder = std::string(FALCIFORM_SOURCE_DIR) + "/Testing/Data/Thesis/";
  commandline::CommandRun run;
  commandline::CohortInput input = commandline::readCorrelationMatrix(folder + file, run);
  commandline::readCohortGroups(folder + "TableIV2Groups.csv", input.cohort, run);
  return input;
}

void printMatrix(const ThesisMetric& metric, const Cohort& cohort) {
  std::printf("Table %s, %s, as read\n\n| case |", metric.table, metric.name);
  for (const std::string& name : cohort.cases) std::printf(" %s |", name.c_str());
  std::printf("\n|---|");
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) std::printf("---|");
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    std::printf("\n| %s |", cohort.cases[i].c_str());
    for (std::size_t j = 0; j < cohort.cases.size(); ++j)
      std::printf(
          " %s |",
          j < i ? "" : fixed(cohort.correlation(static_cast<Index>(i), static_cast<Index>(j)), 2).c_str());
  }
  std::puts("\n");
}

void printTableIv7(const ThesisMetric& metric, const Cohort& cohort, const CohortAnalysis& analysis) {
  for (std::size_t g = 0; g < cohort.groups.size(); ++g) {
    const GroupComparison& c = analysis.groups[g];
    const PrintedRow& thesis = metric.rows[g];
    std::printf("| %s | %s | %s | %s | %s | %s | %s | %s |\n", metric.name, cohort.groups[g].c_str(),
                meanAndSd(c.inGroup, 3).c_str(), thesis.in, meanAndSd(c.outGroup, 3).c_str(), thesis.out,
                pText(c.pooled.p).c_str(), thesis.p);
  }
}

void printTests(const ThesisMetric& metric, const Cohort& cohort, const CohortAnalysis& analysis) {
  const auto row = [&](const std::string& name, const GroupComparison& c) {
    std::printf("| %s | %s | %s | %s | %s | %s | %s | %s |\n", metric.name, name.c_str(),
                fixed(c.difference(), 2).c_str(), pText(c.pooled.p).c_str(), pText(c.welch.p).c_str(),
                pText(c.permutation.pGreater).c_str(), pText(c.permutation.pTwoSided).c_str(),
                fixed(c.permutation.arrangements, 0).c_str());
  };
  for (std::size_t g = 0; g < cohort.groups.size(); ++g) row(cohort.groups[g], analysis.groups[g]);
  row("all", analysis.all);
}

void printLeaveOneOut(const ThesisMetric& metric, const Cohort& cohort, const CohortAnalysis& analysis) {
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    const CaseLeftOut& left = analysis.leaveOneOut[i];
    std::printf(
        "| %s | %s | %s |", metric.name, cohort.cases[i].c_str(),
        cohort.groupOf[i] < 0 ? "" : cohort.groups[static_cast<std::size_t>(cohort.groupOf[i])].c_str());
    for (const GroupComparison& c : left.groups) std::printf(" %s |", pText(c.permutation.pGreater).c_str());
    std::printf(" %s | %s |\n", pText(left.all.permutation.pGreater).c_str(),
                cohort.groups[static_cast<std::size_t>(analysis.mostAlike[i])].c_str());
  }
}

/// How often each test gives at most 0.05, one-sided.
struct Findings {
  int pooled = 0, welch = 0, permutation = 0;
  void count(const GroupComparison& c) {
    pooled += c.pooled.t > 0 && c.pooled.p / 2 <= 0.05;
    welch += c.welch.t > 0 && c.welch.p / 2 <= 0.05;
    permutation += c.permutation.pGreater <= 0.05;
  }
};

/// Shares of random cohorts in which a test finds the groups.
void printFindings(double groupShare, double commonPattern) {
  constexpr int cohorts = 2000;
  Findings all, one;
  for (int seed = 0; seed < cohorts; ++seed) {
    const Cohort cohort = test::randomCohort(groupShare, static_cast<std::uint64_t>(seed), commonPattern);
    all.count(compareAllGroups(cohort));
    one.count(compareGroup(cohort, 2));
  }
  std::printf("| %s | %s |", fixed(groupShare, 1).c_str(), fixed(commonPattern, 1).c_str());
  for (const Findings& f : {all, one})
    for (const int count : {f.pooled, f.welch, f.permutation})
      std::printf(" %s |", fixed(100.0 * count / cohorts, 1).c_str());
  std::puts("");
  std::fflush(stdout);
}

}  // namespace
}  // namespace falciform

int main() {
  using namespace falciform;
  std::vector<Cohort> cohorts;
  std::vector<CohortAnalysis> analyses;
  for (const ThesisMetric& metric : kMetrics) {
    cohorts.push_back(readThesis(metric.file).cohort);
    analyses.push_back(analyseCohort(cohorts.back()));
    printMatrix(metric, cohorts.back());
  }
  const auto forEach = [&](const auto& print) {
    for (std::size_t i = 0; i < cohorts.size(); ++i) print(kMetrics[i], cohorts[i], analyses[i]);
    std::puts("");
  };
  std::puts(
      "| metric | group | in-group | thesis | out-group | thesis | p, pooled t | thesis |\n"
      "|---|---|---|---|---|---|---|---|");
  forEach(printTableIv7);
  std::puts(
      "| metric | group | difference of means | p, pooled t | p, Welch's t | p, permutation, one-sided | "
      "two-sided | arrangements |\n|---|---|---|---|---|---|---|---|");
  forEach(printTests);
  std::puts(
      "| metric | without case | of group | p of A | p of B | p of C | p of all | it is most alike |\n"
      "|---|---|---|---|---|---|---|---|");
  forEach(printLeaveOneOut);
  std::puts(
      "| correlation in groups | pattern of all cases | all groups: pooled t | Welch's t | permutation | "
      "group "
      "of three: pooled t | Welch's t | permutation |\n|---|---|---|---|---|---|---|---|");
  for (const double commonPattern : {0.0, 0.5, 1.0})
    for (const double groupShare : {0.0, 0.5}) printFindings(groupShare, commonPattern);
}
