#include "Modules/CommandLine/CohortStatistics.h"

#include "Modules/CommandLine/CohortFigures.h"
#include "Modules/CommandLine/CohortReport.h"
#include "Modules/CommandLine/CohortTables.h"
#include "Modules/CommandLine/HtmlText.h"
#include "Modules/CommandLine/ReportTables.h"
#include "Modules/CommandLine/SlicerXml.h"
#include "Modules/CommandLine/SvgHeatmap.h"
#include "Version.h"

namespace falciform::commandline {

namespace {

void tell(const std::string& name, const GroupComparison& c, int seed, CommandRun& run) {
  if (c.inGroup.count == 0) {
    run.say(name + ": one case, nothing to compare");
    return;
  }
  run.say(name + ": in-group " + meanAndSd(c.inGroup) + " (" + std::to_string(c.inGroup.count) +
          (c.inGroup.count == 1 ? " pair" : " pairs") + "), out-group " + meanAndSd(c.outGroup) + " (" +
          std::to_string(c.outGroup.count) + "); p: permutation " + pText(c.permutation.pGreater) +
          " one-sided, " + pText(c.permutation.pTwoSided) + " two-sided (" +
          arrangementsText(c.permutation, seed) + "), Welch " + pText(c.welch.p) + ", pooled " +
          pText(c.pooled.p));
}

}  // namespace

std::vector<std::string> cohortStatisticsFiles() {
  return {"groups.csv", "leave_one_out.csv", "likeness.csv", "correlation.csv", "correlation.svg"};
}

std::string writeCohortStatistics(const CohortInput& input, const CohortAnalysis& analysis,
                                  const std::filesystem::path& folder, CommandRun& run) {
  const auto text = [&](const char* name, const std::string& content) {
    writeTextFile(run.outputs.staged(folder / name), Overwrite::Replace, content);
  };
  std::string svg = correlationSvg(input.cohort);
  text("groups.csv", groupsCsv(input.cohort, analysis));
  text("leave_one_out.csv", leaveOneOutCsv(input.cohort, analysis));
  text("likeness.csv", likenessCsv(input.cohort, analysis));
  text("correlation.csv", correlationCsv(input.cohort));
  text("correlation.svg", svg);
  return svg;
}

void tellCohortStatistics(const CohortInput& input, const CohortAnalysis& analysis, int seed,
                          CommandRun& run) {
  for (std::size_t g = 0; g < input.cohort.groups.size(); ++g)
    tell("group " + input.cohort.groups[g], analysis.groups[g], seed, run);
  tell(kAllGroups, analysis.all, seed, run);
}

std::string chainReportHtml(const CohortFile& cohort, const CohortOutcome& outcome,
                            const PermutationSettings& settings, const std::vector<std::string>& matrices,
                            const std::vector<PictureFile>& pictures, const Provenance& provenance) {
  const std::string notice = escaped(kResearchUse);
  const MeasuredCase& target = outcome.cases[outcome.target];
  std::string body =
      "<div class=\"banner\">" + notice + "</div>\n<main>\n<h1>" + escaped(cohort.name) + "</h1>\n";
  body += htmlParagraph("Each case's scan registered by patches, its maps carried to the liver of " +
                            target.name +
                            ", correlated where all cases cover it, and the groups compared. Started " +
                            provenance.startedUtc + ", Falciform " + kVersion + ".",
                        "soft");
  body += htmlWarnings(provenance.warnings) + tablesHtml(outcome);
  std::string gallery;
  for (const PictureFile& picture : pictures) gallery += htmlPicture(picture.file, picture.caption);
  body += htmlSection("Gallery", gallery);
  for (std::size_t k = 0; k < outcome.metrics.size(); ++k) {
    const MetricResult& metric = outcome.metrics[k];
    body += "<h1>" + escaped(metric.info.title) + "</h1>\n";
    if (metric.info.metric == CohortMetric::TrueDisplacement)
      body += htmlParagraph(
          "The truth that comes with these cases: how far each place moved along its normal beside the best "
          "rigid motion of the whole liver, on the same vertices as the measured maps.");
    body += htmlParagraph("Over the " + std::to_string(outcome.overlap.size()) + " of " +
                          std::to_string(target.own->size()) +
                          " vertices of the target liver that all cases cover.");
    body += cohortSections(metric.input, metric.analysis, settings, matrices[k]);
  }
  body += provenanceSection(provenance) + "<footer>" + notice + ".</footer>\n</main>\n";
  return htmlPage(cohort.name + ": Falciform cohort report", body);
}

}  // namespace falciform::commandline
