#include "Modules/AtlasUpdate/SupportWords.h"

#include <QCoreApplication>

namespace falciform {
namespace {

// Linear theory is off by about half the square of the strain; below this ratio of volumes it is a guess.
constexpr double kDoubtfulDetJ = 0.3;

QString tr(const char* text) { return QCoreApplication::translate("SupportWords", text); }

}  // namespace

QString modelWords(const SupportModel& model) {
  return tr("%L1 nodes, %L2 elements, mean edge %3 mm")
      .arg(model.liver.mesh.nodes())
      .arg(model.liver.mesh.size())
      .arg(model.liver.report.edgeLengthMm, 0, 'g', 3);
}

std::vector<std::string> modelWarnings(const SupportModel& model) {
  std::vector<std::string> all = model.liver.report.warnings;
  all.insert(all.end(), model.sites.warnings.begin(), model.sites.warnings.end());
  return all;
}

QString modelState(const SupportLogic& logic) {
  if (!logic.model())
    return tr("No model yet: prepare it, then templates and sliders work. Supports can be painted before.");
  const QString words = tr("Ready: %1.").arg(modelWords(*logic.model()));
  return logic.outdated()
             ? words + tr(" Settings or patches have changed since: prepare it again to use them.")
             : words;
}

QString deformationWords(const DeformedLiver& liver) {
  return tr("Largest displacement of the surface: %1 mm. Smallest ratio of volumes (min det J): %2.")
      .arg(liver.largestMm, 0, 'f', 1)
      .arg(liver.check.minDetJ, 0, 'f', 2);
}

std::vector<std::string> deformationWarnings(const SupportLogic::Answer& answer) {
  std::vector<std::string> warnings = answer.warnings;
  const DeformationCheck& check = answer.liver.check;
  if (check.minDetJ <= 0)
    warnings.push_back(
        tr("Inverted elements: %1 % of the volume is turned inside out, which no tissue can be. "
           "Push less; do not trust what lies near the edges of the supports.")
            .arg(100 * check.foldedShare, 0, 'g', 2)
            .toStdString());
  else if (check.minDetJ < kDoubtfulDetJ)
    warnings.push_back(
        tr("Some tissue is squeezed to %1 % of its volume: beyond what a linear model can tell.")
            .arg(100 * check.minDetJ, 0, 'f', 0)
            .toStdString());
  return warnings;
}

}  // namespace falciform
