#include "Modules/CommandLine/ReportUpdate.h"

#include "Logic/Atlas/UpdateConfidence.h"
#include "Modules/CommandLine/HtmlText.h"
#include "Modules/CommandLine/UpdateTargets.h"

namespace falciform::commandline {

namespace {

double meanExpected(const CaseUpdate& update) {
  return update.updated->moved.arrays.at(kExpectedError).mean();
}

/// What a reader who knows no figures wants to know.
std::string inWords(const CaseUpdate& update, const DistanceMap& registered) {
  const UpdateResult& fit = update.result;
  std::string words = "The liver has bent by up to " + fixed(fit.largestMm, 1) +
                      " mm beside its rigid motion (" +
                      fixed(update.updated->moved.arrays.at(kDisplacement).mean(), 1) +
                      " mm on average over its surface). The scan lies " + fixed(registered.scanAll.rms, 2) +
                      " mm (RMS) from the registered liver and " + fixed(update.distance.scanAll.rms, 2) +
                      " mm from the updated one: fit, not target error. ";
  words += "The error to be expected is " + fixed(meanExpected(update), 1) + " mm on average";
  const auto regions =
      expectationByRegion(update.liver.surface, update.updated->moved.arrays.at(kExpectedError));
  if (!regions.empty())
    words += "; it is largest at " + regions.front().name + " (" + fixed(regions.front().meanMm, 1) +
             " mm) and least at " + regions.back().name + " (" + fixed(regions.back().meanMm, 1) + " mm)";
  words += fit.minDetJ > 0
               ? ". Nowhere is tissue squeezed below " + fixed(100 * fit.minDetJ, 0) + " % of its volume."
               : ". Tissue is folded over somewhere: do not rely on this update.";
  return htmlParagraph(words);
}

std::string figureTable(const CaseUpdate& update) {
  const UpdateResult& fit = update.result;
  HtmlTable table({"Figure", "Value", "Unit", "Meaning"});
  table.row({"RMS residual", fixed(fit.rmsMm, 3), "mm", "fit, not target error: scan to the updated liver"});
  table.row({"Noise", fixed(fit.noiseMm, 2), "mm", "of the scan, as learnt from the residuals"});
  table.row({"Bending", fixed(fit.bendMm, 1), "mm", "RMS that the fit believes in beforehand, as learnt"});
  table.row({"Largest displacement", fixed(fit.largestMm, 1), "mm", "rigid motion apart"});
  table.row({"Expected error", fixed(meanExpected(update), 1), "mm", "mean over the surface"});
  if (update.rigid->expectedErrorMeanMm > 0)
    table.row({"The same of the registration", fixed(update.rigid->expectedErrorMeanMm, 1), "mm",
               "root mean square over the liver"});
  table.row({"Loads that the scan tells", fixed(fit.effectiveParameters, 0), "",
             "of " + std::to_string(fit.coefficients.size())});
  table.row({"Smallest local ratio of volumes", fixed(fit.minDetJ, 2), "", "0 or less: tissue folded over"});
  table.row({"Iterations", std::to_string(fit.iterations), "", fit.stopReason});
  table.row({"Time", fixed(fit.seconds, 2), "s", "of the fit, the model being ready"});
  table.row({"Mesh", std::to_string(update.liver.mesh.size()), "", "elements"});
  return table.html();
}

std::string cell(const std::optional<double>& value) { return value ? fixed(*value, 1) : "-"; }

std::string targetTable(const CaseUpdate& update) {
  const std::vector<TargetRow>& rows = update.updated->targets;
  if (rows.empty()) return "";
  const bool truth = update.updated->targetError.has_value();
  std::vector<std::string> head{"Target", "Moved against the registration (mm)", "Expected error (mm)"};
  if (truth) head.insert(head.end(), {"True error (mm)", "Of the registration (mm)"});
  HtmlTable table(head, 1);
  for (const TargetRow& row : rows) {
    std::vector<std::string> cells{row.structure ? row.name + " (middle)" : row.name,
                                   fixed((row.now - row.rigid).norm(), 1), cell(row.expectedMm)};
    if (truth) cells.insert(cells.end(), {cell(row.errorMm), cell(row.rigidErrorMm)});
    table.row(cells);
  }
  std::string html = "<h3>Targets</h3>\n";
  if (truth) {
    const TargetError& error = *update.updated->targetError;
    html += htmlParagraph("Mean target error " + fixed(error.meanMm, 2) + " mm after the update, " +
                          fixed(error.startMeanMm, 2) + " mm after the registration, " +
                          fixed(error.optimalRigidMeanMm, 2) + " mm by the best rigid motion there is.");
  }
  return html + table.html();
}

}  // namespace

std::string updateCards(const CaseUpdate& update) {
  std::string html = htmlCard(fixed(meanExpected(update), 1) + " mm", "expected error of the updated liver");
  if (update.updated->targetError)
    html += htmlCard(fixed(update.updated->targetError->meanMm, 2) + " mm",
                     "mean target error after the model update");
  return html;
}

std::string updateSection(const CaseOutcome& outcome, const std::string& pictures) {
  if (!outcome.update) return "";
  const CaseUpdate& update = *outcome.update;
  std::vector<std::string> warnings = update.result.warnings;
  for (const std::string& warning : updateWarnings(*update.updated)) warnings.push_back(warning);
  return htmlSection("Model update", inWords(update, *outcome.distance) + htmlWarnings(warnings) + pictures +
                                         "<h3>Figures</h3>\n" + figureTable(update) + targetTable(update));
}

}  // namespace falciform::commandline
