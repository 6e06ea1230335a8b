#include "Modules/CommandLine/CohortFigures.h"

#include <cmath>

#include "Logic/IO/CsvTable.h"
#include "Logic/IO/JsonFile.h"
#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

namespace {

nlohmann::json toJson(const SampleMoments& moments) {
  return {{"pairs", moments.count}, {"mean", numberOrNull(moments.mean)}, {"sd", numberOrNull(moments.sd)}};
}

nlohmann::json toJson(const TTest& test) {
  return {{"t", numberOrNull(test.t)},
          {"degrees_of_freedom", numberOrNull(test.degrees)},
          {"p_two_sided", numberOrNull(test.p)}};
}

nlohmann::json toJson(const std::string& name, const GroupComparison& c) {
  return {{"group", name},
          {"cases", c.cases},
          {"in_group", toJson(c.inGroup)},
          {"out_group", toJson(c.outGroup)},
          {"t_test_pooled", toJson(c.pooled)},
          {"t_test_welch", toJson(c.welch)},
          {"permutation_test",
           {{"arrangements", c.permutation.arrangements},
            {"tried", c.permutation.tried},
            {"exact", c.permutation.exact},
            {"p_greater", numberOrNull(c.permutation.pGreater)},
            {"p_two_sided", numberOrNull(c.permutation.pTwoSided)},
            {"least_p", c.permutation.tried > 0 ? numberOrNull(c.leastP) : nullptr}}}};
}

nlohmann::json toJson(const Cohort& cohort, const std::vector<GroupComparison>& groups) {
  nlohmann::json json = nlohmann::json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) json.push_back(toJson(cohort.groups[g], groups[g]));
  return json;
}

std::string cell(double value) { return std::isfinite(value) ? numberText(value) : ""; }

constexpr char kHead[] =
    "group,cases,in_group_pairs,in_group_mean,in_group_sd,out_group_pairs,out_group_mean,out_group_sd,"
    "p_pooled,p_welch,p_permutation_greater,p_permutation_two_sided,arrangements,tried,exact,least_p\n";

std::string row(const std::string& name, const GroupComparison& c) {
  const PermutationTest& test = c.permutation;
  std::string csv = csvCell(name) + "," + std::to_string(c.cases);
  for (const SampleMoments* moments : {&c.inGroup, &c.outGroup})
    csv += "," + std::to_string(moments->count) + "," + cell(moments->mean) + "," + cell(moments->sd);
  for (const double p : {c.pooled.p, c.welch.p, test.pGreater, test.pTwoSided}) csv += "," + cell(p);
  if (test.tried == 0) return csv + ",,,,\n";
  return csv + "," + cell(test.arrangements) + "," + std::to_string(test.tried) + "," +
         (test.exact ? "1" : "0") + "," + cell(c.leastP) + "\n";
}

}  // namespace

std::string groupNameOf(const Cohort& cohort, std::size_t place) {
  const int group = cohort.groupOf[place];
  return group < 0 ? "" : cohort.groups[static_cast<std::size_t>(group)];
}

nlohmann::json cohortFigures(const CohortInput& input, const CohortAnalysis& analysis) {
  const Cohort& cohort = input.cohort;
  nlohmann::json left = nlohmann::json::array(), cases = nlohmann::json::array(),
                 rows = nlohmann::json::array();
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    const auto at = static_cast<Index>(i);
    left.push_back({{"left_out", cohort.cases[i]},
                    {"groups", toJson(cohort, analysis.leaveOneOut[i].groups)},
                    {"all_groups", toJson(kAllGroups, analysis.leaveOneOut[i].all)}});
    nlohmann::json likeness = nlohmann::json::object(), values = nlohmann::json::array();
    for (std::size_t g = 0; g < cohort.groups.size(); ++g)
      likeness[cohort.groups[g]] = numberOrNull(analysis.likeness(at, static_cast<Index>(g)));
    for (Index j = 0; j < cohort.correlation.cols(); ++j) values.push_back(cohort.correlation(at, j));
    const int alike = analysis.mostAlike[i];
    cases.push_back({{"case", cohort.cases[i]},
                     {"group", groupNameOf(cohort, i)},
                     {"mean_correlation_with", likeness},
                     {"most_alike", alike < 0 ? "" : cohort.groups[static_cast<std::size_t>(alike)]}});
    rows.push_back(std::move(values));
  }
  nlohmann::json figures = {{"groups", toJson(cohort, analysis.groups)},
                            {"all_groups", toJson(kAllGroups, analysis.all)},
                            {"in_group_mean", analysis.all.inGroup.mean},
                            {"out_group_mean", analysis.all.outGroup.mean},
                            {"p_permutation", analysis.all.permutation.pGreater},
                            {"leave_one_out", left},
                            {"cases", cases},
                            {"correlation", rows}};
  if (input.vertices > 0) {
    figures["vertices"] = input.vertices;
    figures["overlap_vertices"] = input.overlap;
  }
  return figures;
}

std::string groupsCsv(const Cohort& cohort, const CohortAnalysis& analysis) {
  std::string csv = kHead;
  for (std::size_t g = 0; g < cohort.groups.size(); ++g) csv += row(cohort.groups[g], analysis.groups[g]);
  return csv + row(kAllGroups, analysis.all);
}

std::string leaveOneOutCsv(const Cohort& cohort, const CohortAnalysis& analysis) {
  std::string csv = std::string("left_out,") + kHead;
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    const CaseLeftOut& left = analysis.leaveOneOut[i];
    const std::string name = csvCell(cohort.cases[i]) + ",";
    for (std::size_t g = 0; g < cohort.groups.size(); ++g)
      csv += name + row(cohort.groups[g], left.groups[g]);
    csv += name + row(kAllGroups, left.all);
  }
  return csv;
}

std::string likenessCsv(const Cohort& cohort, const CohortAnalysis& analysis) {
  std::string csv = "case,group";
  for (const std::string& group : cohort.groups) csv += "," + csvCell("mean correlation with " + group);
  csv += ",most_alike\n";
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    csv += csvCell(cohort.cases[i]) + "," + csvCell(groupNameOf(cohort, i));
    for (Index g = 0; g < analysis.likeness.cols(); ++g)
      csv += "," + cell(analysis.likeness(static_cast<Index>(i), g));
    const int alike = analysis.mostAlike[i];
    csv += "," + (alike < 0 ? "" : csvCell(cohort.groups[static_cast<std::size_t>(alike)])) + "\n";
  }
  return csv;
}

std::string correlationCsv(const Cohort& cohort) {
  std::string csv = "case";
  for (const std::string& name : cohort.cases) csv += "," + csvCell(name);
  csv += "\n";
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    csv += csvCell(cohort.cases[i]);
    for (Index j = 0; j < cohort.correlation.cols(); ++j)
      csv += "," + cell(cohort.correlation(static_cast<Index>(i), j));
    csv += "\n";
  }
  return csv;
}

}  // namespace falciform::commandline
