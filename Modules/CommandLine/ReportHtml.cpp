#include "Modules/CommandLine/ReportHtml.h"

#include "Modules/CommandLine/HtmlText.h"
#include "Modules/CommandLine/ReportTables.h"
#include "Modules/CommandLine/ReportUpdate.h"
#include "Modules/CommandLine/SlicerXml.h"
#include "Version.h"

namespace falciform::commandline {

namespace {

std::string cards(const CaseOutcome& outcome) {
  const RegistrationResult& fit = *outcome.registration;
  std::string html = "<div class=\"cards\">\n" +
                     htmlCard(fixed(fit.rmsMm, 2) + " mm", "RMS residual: fit, not target error");
  if (outcome.targetError) {
    html += htmlCard(fixed(outcome.targetError->meanMm, 2) + " mm",
                     "mean target error of the registration over " +
                         std::to_string(outcome.targetError->names.size()) + " targets with known truth");
    html += htmlCard(fixed(outcome.targetError->optimalRigidMeanMm, 2) + " mm",
                     "least mean target error of any rigid motion, about");
  }
  if (outcome.update) html += updateCards(*outcome.update);
  html += htmlCard(fixed(100 * fit.coverage, 0) + " %", "of the pre-op surface within reach of the scan");
  html += htmlCard(fixed(outcome.distance->preopAll.p95Absolute, 1) + " mm",
                   "95 % of covered places lie nearer to the scan than this");
  html += htmlCard(std::to_string(fit.basins.size()), fit.basins.size() == 1
                                                          ? "pose found: all starts agree"
                                                          : "different poses found by the starts");
  return html + "</div>\n";
}

std::string pictureGrid(const std::vector<PictureFile>& pictures) {
  std::string html = "<div class=\"pictures\">\n";
  for (const PictureFile& picture : pictures) html += htmlPicture(picture.file, picture.caption);
  return html + "</div>\n";
}

}  // namespace

std::string reportHtml(const CaseOutcome& outcome, const CaseSettings& settings, const Provenance& provenance,
                       const std::vector<PictureFile>& pictures,
                       const std::vector<PictureFile>& updatePictures) {
  const std::string notice = escaped(kResearchUse);
  std::string body =
      "<div class=\"banner\">" + notice + "</div>\n<main>\n<h1>" + escaped(outcome.name) + "</h1>\n";
  body += htmlParagraph(
      outcome.update
          ? "Registration of an intra-operative scan to the pre-operative liver, and the whole liver moved "
            "to "
            "where the scan shows it to be, bending included."
          : "Rigid registration of an intra-operative scan to the pre-operative liver, and the distance that "
            "remains.",
      "soft");
  body += htmlParagraph("Started " + provenance.startedUtc + ", Falciform " + kVersion + ".", "soft");
  body += cards(outcome) + htmlWarnings(provenance.warnings);
  body += htmlSection("Pictures", pictureGrid(pictures));
  body += updateSection(outcome, pictureGrid(updatePictures));
  body += surfaceSection(outcome) + patchSection(outcome) + registrationSection(outcome) +
          targetSection(outcome) + distanceSection(outcome) + settingsSection(settings) +
          provenanceSection(provenance);
  body += "<footer>" + notice +
          ". Lengths in mm. A small residual says that the surfaces fit, not that a point inside the liver "
          "is where it is shown.</footer>\n</main>\n";
  return htmlPage(outcome.name + ": Falciform report", body);
}

}  // namespace falciform::commandline
