#include "Modules/CommandLine/CohortTables.h"

#include <cmath>

#include "Logic/IO/CsvTable.h"
#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/CohortFigures.h"
#include "Modules/CommandLine/CohortReport.h"
#include "Modules/CommandLine/HtmlText.h"

namespace falciform::commandline {

namespace {

/// A table as rows of text, to be written as Markdown or HTML.
struct Rows {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] std::string markdown() const {
    const auto line = [](const std::vector<std::string>& cells) {
      std::string text = "|";
      for (const std::string& cell : cells) text += " " + cell + " |";
      return text + "\n";
    };
    std::string text = line(head) + "|";
    for (std::size_t i = 0; i < head.size(); ++i) text += "---|";
    text += "\n";
    for (const auto& row : rows) text += line(row);
    return text;
  }
  [[nodiscard]] std::string html() const {
    HtmlTable table(head, 1);
    for (const auto& row : rows) table.row(row);
    return table.html();
  }
};

std::string pm(const DistanceStatistics& s) { return fixed(s.mean, 2) + " ± " + fixed(s.sd, 2); }

struct Errors {
  DistanceStatistics toTarget, toSource, overlap;
};

Errors errorsOf(const MeasuredCase& measured, const std::vector<Index>& overlap) {
  const VectorXd& toSource = measured.carried.targetToSource;
  return {distanceStatistics(measured.carried.sourceToTarget), distanceStatistics(toSource),
          distanceStatistics(VectorXd(toSource(overlap)))};
}

Rows tableIv3(const CohortOutcome& outcome) {
  Rows table{{"source", "group", "SRC to TAR, mean ± SD mm", "max", "TAR to SRC, mean ± SD mm", "max",
              "overlap, mean ± SD mm", "max", "least det J"},
             {}};
  for (std::size_t i = 0; i < outcome.cases.size(); ++i) {
    if (i == outcome.target) continue;
    const MeasuredCase& measured = outcome.cases[i];
    const Errors errors = errorsOf(measured, outcome.overlap);
    table.rows.push_back({measured.name, measured.group, pm(errors.toTarget), fixed(errors.toTarget.max, 2),
                          pm(errors.toSource), fixed(errors.toSource.max, 2), pm(errors.overlap),
                          fixed(errors.overlap.max, 2), fixed(measured.carried.leastDeterminant, 2)});
  }
  return table;
}

Rows tableIv4(const CohortOutcome& outcome) {
  Rows table{{"case", "group", "signed distance, mean ± SD mm", "median", "range", "coverage %",
              "registration rms mm", "pose off by mm"},
             {}};
  for (const MeasuredCase& measured : outcome.cases) {
    const DistanceMap& map = *measured.outcome.distance;
    table.rows.push_back({measured.name, measured.group, pm(map.preopAll), fixed(map.preopAll.median, 2),
                          fixed(map.preopAll.max, 2) + ", " + fixed(map.preopAll.min, 2),
                          fixed(100 * map.coverage, 1), fixed(measured.outcome.registration->rmsMm, 2),
                          measured.poseErrorMm ? fixed(*measured.poseErrorMm, 1) : "-"});
  }
  return table;
}

/// Upper half, as the thesis prints Tables IV.5 and IV.6.
Rows correlations(const Cohort& cohort) {
  Rows table{{"case"}, {}};
  for (const std::string& name : cohort.cases) table.head.push_back(name);
  for (std::size_t i = 0; i < cohort.cases.size(); ++i) {
    const std::string group = groupNameOf(cohort, i);
    std::vector<std::string> row{cohort.cases[i] + (group.empty() ? "" : " (" + group + ")")};
    for (std::size_t j = 0; j < cohort.cases.size(); ++j)
      row.push_back(j < i ? "" : fixed(cohort.correlation(static_cast<Index>(i), static_cast<Index>(j)), 2));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Rows tableIv7(const CohortOutcome& outcome) {
  Rows table{{"metric", "group", "in-group", "out-group", "p, pooled t", "p, Welch's t",
              "p, permutation, one-sided", "two-sided", "arrangements"},
             {}};
  for (const MetricResult& metric : outcome.metrics) {
    const auto row = [&](const std::string& group, const GroupComparison& c) {
      table.rows.push_back({metric.info.title, group, meanAndSd(c.inGroup), meanAndSd(c.outGroup),
                            pText(c.pooled.p), pText(c.welch.p), pText(c.permutation.pGreater),
                            pText(c.permutation.pTwoSided),
                            c.permutation.tried > 0 ? fixed(c.permutation.arrangements, 0) : "-"});
    };
    for (std::size_t g = 0; g < metric.input.cohort.groups.size(); ++g)
      row(metric.input.cohort.groups[g], metric.analysis.groups[g]);
    row(kAllGroups, metric.analysis.all);
  }
  return table;
}

}  // namespace

std::string surfaceErrorsCsv(const CohortOutcome& outcome) {
  std::string csv = "source,group";
  for (const char* what : {"source_to_target", "target_to_source", "overlap"})
    for (const char* figure : {"mean_mm", "sd_mm", "max_mm"}) csv += std::string(",") + what + "_" + figure;
  csv += ",least_determinant\n";
  for (std::size_t i = 0; i < outcome.cases.size(); ++i) {
    if (i == outcome.target) continue;
    const MeasuredCase& measured = outcome.cases[i];
    const Errors errors = errorsOf(measured, outcome.overlap);
    csv += csvCell(measured.name) + "," + csvCell(measured.group);
    for (const DistanceStatistics* s : {&errors.toTarget, &errors.toSource, &errors.overlap})
      csv += "," + numberText(s->mean) + "," + numberText(s->sd) + "," + numberText(s->max);
    csv += "," + numberText(measured.carried.leastDeterminant) + "\n";
  }
  return csv;
}

std::string casesCsv(const CohortOutcome& outcome) {
  std::string csv =
      "case,group,coverage,mean_mm,sd_mm,median_mm,max_mm,min_mm,covered_vertices,registration_rms_mm,"
      "pose_error_rms_mm\n";
  for (const MeasuredCase& measured : outcome.cases) {
    const DistanceMap& map = *measured.outcome.distance;
    const DistanceStatistics& s = map.preopAll;
    csv += csvCell(measured.name) + "," + csvCell(measured.group) + "," + numberText(map.coverage);
    for (const double value : {s.mean, s.sd, s.median, s.max, s.min})
      csv += "," + (std::isfinite(value) ? numberText(value) : "");
    csv += "," + std::to_string(s.count) + "," + numberText(measured.outcome.registration->rmsMm) + "," +
           (measured.poseErrorMm ? numberText(*measured.poseErrorMm) : "") + "\n";
  }
  return csv;
}

std::string mapsCsv(const CohortOutcome& outcome, std::size_t metric) {
  std::string csv = "vertex";
  for (const MeasuredCase& measured : outcome.cases) csv += "," + csvCell(measured.name);
  csv += "\n";
  for (Index v = 0; v < outcome.cases[outcome.target].own->size(); ++v) {
    csv += std::to_string(v);
    for (const MeasuredCase& measured : outcome.cases) {
      const double value = measured.carried.values(v, static_cast<Index>(metric));
      csv += "," + (std::isfinite(value) ? numberText(value) : "");
    }
    csv += "\n";
  }
  return csv;
}

std::string tablesMarkdown(const CohortOutcome& outcome) {
  const MeasuredCase& target = outcome.cases[outcome.target];
  std::string text =
      "## Table IV.3: inter-patient registration, target " + target.name + "\n\n" +
      tableIv3(outcome).markdown() + "\nThe overlap has " + std::to_string(outcome.overlap.size()) +
      " of the target's " + std::to_string(target.own->size()) +
      " vertices.\n\n## Table IV.4: signed closest-point distance\n\n" + tableIv4(outcome).markdown();
  const char* numbers[] = {"Table IV.5", "Table IV.6", "The truth beside Table IV.5"};
  for (std::size_t k = 0; k < outcome.metrics.size(); ++k)
    text += std::string("\n## ") + numbers[k] + ": correlation of the " + outcome.metrics[k].info.folder +
            " maps\n\n" + correlations(outcome.metrics[k].input.cohort).markdown();
  return text + "\n## Table IV.7: groups\n\n" + tableIv7(outcome).markdown();
}

std::string tablesHtml(const CohortOutcome& outcome) {
  return htmlSection("Each case: registration by patches and signed distance",
                     htmlParagraph("The thesis's Table IV.4. Positive where the scan lies outside the pre-op "
                                   "surface; only where it covers. Pose off by: root mean square over the "
                                   "liver against the best rigid pose of the true motion, where it is "
                                   "known.") +
                         tableIv4(outcome).html()) +
         htmlSection(
             "Inter-patient registration",
             htmlParagraph("The thesis's Table IV.3: closest-point distances after the source's liver was "
                           "brought onto the target's; the overlap is where every case has values. They say "
                           "nothing about motion along the surface. Least det J above 0: nothing folds.") +
                 tableIv3(outcome).html());
}

}  // namespace falciform::commandline
