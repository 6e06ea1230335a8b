#include "Modules/CommandLine/TrialReport.h"

#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/HtmlText.h"
#include "Modules/CommandLine/ReportTables.h"
#include "Modules/CommandLine/SlicerXml.h"
#include "Modules/CommandLine/SvgHistogram.h"
#include "Modules/CommandLine/TrialTables.h"
#include "Version.h"

namespace falciform::commandline {

namespace {

template <class Value>
std::string histogram(const TrialOutcome& outcome, const std::string& axis, double thresholdMm,
                      const Value& value) {
  std::vector<HistogramStrip> strips;
  for (std::size_t i = 0; i < outcome.methods.size(); ++i) {
    const TrialSummary& summary = outcome.summaries[i];
    strips.push_back(
        {outcome.methods[i].name,
         std::to_string(summary.successes) + " of " + std::to_string(summary.trials) + " succeed",
         {},
         {}});
  }
  for (const TrialRecord& record : outcome.records) {
    HistogramStrip& strip = strips[static_cast<std::size_t>(record.method)];
    strip.values.push_back(value(record));
    strip.success.push_back(record.success);
  }
  return histogramSvg(axis, strips, thresholdMm);
}

std::string figure(const std::string& svg, const std::string& caption) {
  return "<figure>" + svg + "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string criterion(const TrialOutcome& outcome) {
  return outcome.targets > 0 ? "mean target error below " + fixed(outcome.settings.successTreMm, 1) + " mm"
                             : "RMS residual below " + fixed(outcome.settings.successRmsMm, 1) + " mm";
}

std::string cards(const TrialOutcome& outcome) {
  std::string html = "<div class=\"cards\">\n";
  for (std::size_t i = 0; i < outcome.methods.size(); ++i) {
    const TrialSummary& s = outcome.summaries[i];
    html += htmlCard(fixed(100 * static_cast<double>(s.successes) / static_cast<double>(s.trials), 1) + " %",
                     outcome.methods[i].name + ": " + std::to_string(s.successes) + " of " +
                         std::to_string(s.trials) + " succeed");
  }
  return html + "</div>\n";
}

std::string trialSetTable(const TrialOutcome& outcome) {
  HtmlTable table({"What", "Value"});
  const std::string each = fixed(outcome.scale.translationMm, 1) + " mm along each axis";
  const bool euler = outcome.settings.distribution == TrialDistribution::Euler;
  table.row({"Scale", outcome.scaleName});
  table.row({"Rotation", (euler ? "an angle about each axis, uniform within ± "
                                : "uniform on SO(3) (Haar measure) among the rotations by at most ") +
                             fixed(outcome.scale.rotationDeg, 1) + " deg" +
                             (euler ? ", as the thesis; not uniform on SO(3)" : "")});
  table.row({"Translation", "uniform within ± " + each});
  table.row(
      {"Turned about", "the scan's centroid; the scan itself is moved and registered from where it lies"});
  const ScanVariation& varied = outcome.settings.variation;
  table.row({"Scan of a trial", fixed(100 * varied.keepShare, 1) + " % of the points, noise " +
                                    fixed(varied.noiseMm, 2) + " mm an axis, " +
                                    fixed(100 * varied.outlierShare, 1) + " % outliers, " +
                                    fixed(100 * varied.mislabelShare, 1) + " % of patch points mislabelled"});
  table.row({"Trials", std::to_string(outcome.settings.count) + " for each method, the same for all"});
  table.row({"Seed", std::to_string(outcome.settings.seed)});
  table.row({"Success", criterion(outcome)});
  table.row({"Points", std::to_string(outcome.scanPoints) + " / " + std::to_string(outcome.preopPoints) +
                           " (scan / pre-op)"});
  table.row({"Gold standard", outcome.gold.source});
  table.row({"Its RMS residual", fixed(outcome.gold.rmsMm, 2) + " mm"});
  if (outcome.targets > 0) {
    table.row({"Its target error", fixed(outcome.gold.targetErrorMm, 2) + " mm over " +
                                       std::to_string(outcome.targets) + " targets"});
    table.row({"Least of any rigid motion, about", fixed(outcome.optimalRigidMm, 2) + " mm"});
  }
  return table.html();
}

std::string timing(const TrialOutcome& outcome) {
  const int beside =
      outcome.settings.atOnce == 0 ? outcome.threads : std::min(outcome.settings.atOnce, outcome.threads);
  return "One registration, the pre-op side prepared before (" + fixed(outcome.preparationSeconds, 2) +
         " s, once for all); measured with " +
         (beside > 1 ? std::to_string(beside) + " registrations beside each other on " +
                           std::to_string(outcome.threads) +
                           " threads, so each is slower than alone: --at-once 1 gives honest times."
                     : "one registration at a time on " + std::to_string(outcome.threads) +
                           (outcome.threads == 1 ? " thread." : " threads."));
}

}  // namespace

TrialHistograms trialHistograms(const TrialOutcome& outcome) {
  const bool targets = outcome.targets > 0;
  return {histogram(outcome, "RMS residual (mm)", targets ? 0 : outcome.settings.successRmsMm,
                    [](const TrialRecord& record) { return record.rmsMm; }),
          !targets ? ""
                   : histogram(outcome, "Target error (mm)", outcome.settings.successTreMm,
                               [](const TrialRecord& record) { return record.targetErrorMm; })};
}

std::string trialReportHtml(const TrialOutcome& outcome, const TrialHistograms& histograms,
                            const Provenance& provenance) {
  const std::string notice = escaped(kResearchUse);
  const bool targets = outcome.targets > 0;
  std::string body = "<div class=\"banner\">" + notice + "</div>\n<main>\n<h1>Registration trials</h1>\n";
  body += htmlParagraph(std::to_string(outcome.settings.count) + " perturbations of the scan (" +
                            outcome.scaleName +
                            " scale), registered anew by each method. Success: " + criterion(outcome) +
                            ". Started " + provenance.startedUtc + ", Falciform " + kVersion + ".",
                        "soft");
  body += cards(outcome) + htmlWarnings(provenance.warnings);
  body +=
      htmlSection("Success", htmlParagraph(std::string("Mean ± standard deviation, in the form of the "
                                                       "thesis's ") +
                                           (targets ? "Tables III.1 and III.2." : "Tables III.5 and III.6.") +
                                           " Residual is fit, not target error.") +
                                 successTable(outcome));
  const std::string note = alikeNote(outcome);
  body +=
      htmlSection("What that proves",
                  htmlParagraph("Exact intervals (Clopper and Pearson); \"proves at least\" is one-sided, 95 "
                                "%. Flagged: the registration gave a warning.") +
                      proofTable(outcome) + (note.empty() ? "" : htmlParagraph(note)));
  body += htmlSection("Where the trials ended",
                      htmlParagraph("Results that place the surface's outermost points within " +
                                    fixed(outcome.settings.basinMm, 1) +
                                    " mm of each other count as one pose; near the gold standard: every "
                                    "pre-op vertex.") +
                          poseTable(outcome));
  std::string figures;
  if (targets)
    figures += figure(histograms.targetError,
                      "Target error of all trials. The axis is logarithmic; each strip "
                      "has its own scale of counts.");
  figures += figure(histograms.rms,
                    "RMS residual of all trials (fit). A wrong pose may fit as well as the right "
                    "one.");
  body += htmlSection("Histograms", figures);
  body += htmlSection("Spread", spreadTable(outcome));
  body += htmlSection("Time", htmlParagraph(timing(outcome)) +
                                  htmlParagraph("In the form of the thesis's Table III.7: means over the "
                                                "successful registrations. Time an iteration is all time "
                                                "over the iterations of the last start: a search for the "
                                                "start is in it.",
                                                "soft") +
                                  timeTable(outcome));
  body += htmlSection("Trial set", trialSetTable(outcome));
  body += htmlSection("Settings of the methods", methodSettingsTable(outcome));
  body += provenanceSection(provenance);
  body += "<footer>" + notice + ". Lengths in mm.</footer>\n</main>\n";
  return htmlPage("Registration trials: Falciform report", body);
}

}  // namespace falciform::commandline
