#include "Modules/CommandLine/CohortReport.h"

#include <cmath>
#include <cstdio>

#include "Modules/CommandLine/CohortFigures.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/HtmlText.h"
#include "Modules/CommandLine/ReportTables.h"
#include "Modules/CommandLine/SlicerXml.h"
#include "Version.h"

namespace falciform::commandline {

namespace {

std::string cards(const CohortInput& input, const CohortAnalysis& analysis) {
  const GroupComparison& all = analysis.all;
  return "<div class=\"cards\">\n" +
         htmlCard(fixed(all.inGroup.mean, 2), "mean correlation of two cases of one group") +
         htmlCard(fixed(all.outGroup.mean, 2), "mean correlation of two cases of different procedures") +
         htmlCard(pText(all.permutation.pGreater),
                  "permutation test of all groups at once, one-sided: the share of all ways to deal out the "
                  "labels that give as large a difference") +
         htmlCard(std::to_string(input.cohort.cases.size()),
                  "cases in " + std::to_string(input.cohort.groups.size()) + " groups") +
         "</div>\n";
}

/// Two tables, each as wide as a page: the means, and what the tests say of them.
std::string groupTables(const Cohort& cohort, const CohortAnalysis& analysis, int seed) {
  HtmlTable means(
      {"Group", "Cases", "Pairs in group", "In-group mean ± SD", "Pairs out of group", "Out-group mean ± SD"},
      1);
  HtmlTable tests({"p", "Permutation, one-sided", "Permutation, two-sided", "Welch's t", "Pooled t", "Tried"},
                  1);
  const auto row = [&](const std::string& name, const GroupComparison& c) {
    means.row({name, std::to_string(c.cases), std::to_string(c.inGroup.count), meanAndSd(c.inGroup),
               std::to_string(c.outGroup.count), meanAndSd(c.outGroup)});
    tests.row({name, pText(c.permutation.pGreater), pText(c.permutation.pTwoSided), pText(c.welch.p),
               pText(c.pooled.p), arrangementsText(c.permutation, seed)});
  };
  for (std::size_t g = 0; g < cohort.groups.size(); ++g) row(cohort.groups[g], analysis.groups[g]);
  row(kAllGroups, analysis.all);
  return means.html() + tests.html();
}

std::string leaveOneOutTable(const Cohort& cohort, const CohortAnalysis& analysis) {
  std::vector<std::string> head{"Without", "Group"};
  for (const std::string& group : cohort.groups) head.push_back(group + ": in / out; p");
  head.push_back(std::string(kAllGroups) + ": in / out; p");
  HtmlTable table(head, 2);
  const auto cell = [](const GroupComparison& c) {
    return c.inGroup.count == 0 ? "-"
                                : fixed(c.inGroup.mean, 2) + " / " + fixed(c.outGroup.mean, 2) + "; " +
                                      pText(c.permutation.pGreater);
  };
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    std::vector<std::string> row{cohort.cases[i], groupNameOf(cohort, i)};
    for (const GroupComparison& c : analysis.leaveOneOut[i].groups) row.push_back(cell(c));
    row.push_back(cell(analysis.leaveOneOut[i].all));
    table.row(row);
  }
  return table.html();
}

std::string likenessTable(const Cohort& cohort, const CohortAnalysis& analysis) {
  std::vector<std::string> head{"Case", "Group", "Most alike"};
  for (const std::string& group : cohort.groups) head.push_back("with " + group);
  HtmlTable table(head, 3);
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    const int alike = analysis.mostAlike[i];
    std::vector<std::string> row{cohort.cases[i], groupNameOf(cohort, i),
                                 alike < 0 ? "-" : cohort.groups[static_cast<std::size_t>(alike)]};
    for (Index g = 0; g < analysis.likeness.cols(); ++g)
      row.push_back(fixed(analysis.likeness(static_cast<Index>(i), g), 2));
    table.row(row);
  }
  return table.html();
}

}  // namespace

std::string meanAndSd(const SampleMoments& moments, int decimals) {
  if (moments.count == 0) return "-";
  const std::string mean = fixed(moments.mean, decimals);
  return moments.count == 1 ? mean : mean + " ± " + fixed(moments.sd, decimals);
}

std::string pText(double p) { return p < 0.0005 ? "< 0.001" : fixed(p, 3); }

std::string arrangementsText(const PermutationTest& test, int seed) {
  if (test.tried == 0) return "-";
  char count[40];
  std::snprintf(count, sizeof count, test.arrangements < 1e7 ? "%.0f" : "%.1e", test.arrangements);
  return test.exact ? "all " + std::string(count) + " arrangements"
                    : std::to_string(test.tried) + " of " + count + " arrangements, drawn with seed " +
                          std::to_string(seed);
}

std::string cohortSections(const CohortInput& input, const CohortAnalysis& analysis,
                           const PermutationSettings& settings, const std::string& matrixSvg) {
  const Cohort& cohort = input.cohort;
  std::string body = cards(input, analysis);
  body += htmlSection(
      "Groups",
      htmlParagraph(
          "In the form of the thesis's Table IV.7. The t tests take the correlations as independent "
          "draws, which they are not: each case stands in many pairs. They are here to be compared "
          "with the thesis (pooled) and with each other; the permutation test holds as it is. A "
          "test for each group is several tests; the last row is one.") +
          groupTables(cohort, analysis, settings.seed));
  body +=
      htmlSection("Correlation of each two cases",
                  "<figure>" + matrixSvg +
                      "<figcaption>Orange: alike. Blue: opposed. Frames: groups.</figcaption></figure>\n");
  body += htmlSection("Each case left out",
                      htmlParagraph("In-group mean / out-group mean; p of the permutation test, one-sided. A "
                                    "finding that goes with one case rests on that case.") +
                          leaveOneOutTable(cohort, analysis));
  body += htmlSection("What each case is most alike",
                      htmlParagraph("Mean correlation with the other cases of each group.") +
                          likenessTable(cohort, analysis));
  return body;
}

std::string cohortReportHtml(const CohortInput& input, const CohortAnalysis& analysis,
                             const PermutationSettings& settings, const std::string& matrixSvg,
                             const Provenance& provenance) {
  const std::string notice = escaped(kResearchUse);
  std::string body =
      "<div class=\"banner\">" + notice + "</div>\n<main>\n<h1>" + escaped(input.name) + "</h1>\n";
  body += htmlParagraph(
      "How alike the deformations of the cases are, and whether those of one procedure are "
      "more alike. Started " +
          provenance.startedUtc + ", Falciform " + kVersion + ".",
      "soft");
  if (input.vertices > 0)
    body +=
        htmlParagraph("Correlated over the " + std::to_string(input.overlap) + " of " +
                      std::to_string(input.vertices) + " vertices of the target liver that all cases cover.");
  body += htmlWarnings(provenance.warnings) + cohortSections(input, analysis, settings, matrixSvg);
  body += provenanceSection(provenance);
  body += "<footer>" + notice + ".</footer>\n</main>\n";
  return htmlPage(input.name + ": Falciform cohort report", body);
}

}  // namespace falciform::commandline
