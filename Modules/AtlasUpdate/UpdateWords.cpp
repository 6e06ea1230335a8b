#include "Modules/AtlasUpdate/UpdateWords.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <cmath>

#include "Logic/Atlas/ScanNext.h"
#include "Logic/Atlas/UpdateConfidence.h"

namespace falciform {
namespace {

constexpr double kWorthScanningMm = 0.05;  // mean gain over a region below which no advice is given
constexpr double kStandsOut = 1.3;         // a region's expected error beside the mean, to be named

QString tr(const char* text) { return QCoreApplication::translate("UpdateWords", text); }

QString mm(double value, int decimals = 1) { return tr("%1 mm").arg(value, 0, 'f', decimals); }

bool isTumour(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.find("tumour") != std::string::npos || name.find("tumor") != std::string::npos;
}

/// "3.2 mm at tumour 1, 2.8 mm at tumour 2"
QStringList atTumours(const UpdatedCase& made) {
  QStringList words;
  for (const UpdatedTarget& target : made.targets)
    if (target.structure && isTumour(target.name))
      words << tr("%1 at %2").arg(mm(target.expectedErrorMm), QString::fromStdString(target.name));
  return words;
}

QString whereItSaysLeast(const UpdatedCase& made) {
  const auto regions = expectationByRegion(*made.preop, made.surface->arrays.at(kExpectedError));
  QStringList named;
  for (const RegionExpectation& region : regions)
    if (region.meanMm > kStandsOut * made.expectedErrorMeanMm && named.size() < 2)
      named << tr("%1 (%2)").arg(QString::fromStdString(region.name), mm(region.meanMm));
  return named.isEmpty() ? tr("No side of the liver stands out as less certain.")
                         : tr("The scan says little about %1.").arg(named.join(tr(" and ")));
}

QString whereToScanNext(const UpdatedCase& made) {
  const auto regions = expectationByRegion(*made.preop, made.surface->arrays.at(kScanGain));
  return regions.empty() || regions.front().meanMm < kWorthScanningMm
             ? QString()
             : tr(" More scanning would help most at %1.").arg(QString::fromStdString(regions.front().name));
}

QString trueErrors(const UpdatedCase& made) {
  double now = 0, rigid = 0;
  int count = 0;
  for (const UpdatedTarget& target : made.targets)
    if (target.trueErrorMm && target.rigidErrorMm) {
      now += *target.trueErrorMm;
      rigid += *target.rigidErrorMm;
      ++count;
    }
  if (count == 0) return {};
  return tr(" True error at the %1 targets: %2 on average; by the registration alone %3.")
      .arg(count)
      .arg(mm(now / count, 2), mm(rigid / count, 2));
}

}  // namespace

QString updateModelState(const ModelUpdateLogic& logic) {
  if (!logic.model()) return tr("No model yet. It can be prepared before the scan is there.");
  const LoadResponses& loads = logic.model()->responses();
  const QString words = tr("Ready: %L1 nodes, %L2 elements, answers to %3 surface loads.")
                            .arg(loads.mesh.nodes())
                            .arg(loads.mesh.size())
                            .arg(loads.loads());
  return logic.modelOutdated() ? words + tr(" Settings have changed since: prepare it again to use them.")
                               : words;
}

QString liveWords(const std::vector<UpdateRecord>& records) {
  if (records.empty()) return {};
  QString words = tr("Iteration %1: RMS residual %2 (fit), bending %3")
                      .arg(records.back().iteration)
                      .arg(mm(records.back().rmsMm, 2), mm(records.back().bendMm));
  for (auto record = records.rbegin(); record != records.rend(); ++record)
    if (std::isfinite(record->expectedMm)) {
      words += tr(", expected error %1").arg(mm(record->expectedMm));
      break;
    }
  return words;
}

QString updateFigures(const UpdateResult& update) {
  return tr("%1 after %2 iterations, %3 s. RMS residual %4 (fit, not target error); bending %5 RMS, %6 at "
            "most; "
            "smallest ratio of volumes (min det J) %7; the scan determines %8 of the loads.")
      .arg(update.converged                             ? tr("Settled")
           : update.stopReason == "stopped by the user" ? tr("Stopped")
                                                        : tr("Not settled"))
      .arg(update.iterations)
      .arg(update.seconds, 0, 'f', 1)
      .arg(mm(update.rmsMm, 2), mm(update.bendMm), mm(update.largestMm))
      .arg(update.minDetJ, 0, 'f', 2)
      .arg(update.effectiveParameters, 0, 'f', 0);
}

QString confidenceWords(const UpdatedCase& made) {
  QString words = tr("Expected error %1 on average").arg(mm(made.expectedErrorMeanMm));
  if (const QStringList tumours = atTumours(made); !tumours.isEmpty())
    words += tr("; %1").arg(tumours.join(", "));
  words += ". " + whereItSaysLeast(made) + whereToScanNext(made);
  if (made.registration->expectedErrorMeanMm > 0)
    words += tr(" The rigid registration alone expects %1.").arg(mm(made.registration->expectedErrorMeanMm));
  return words + trueErrors(made);
}

std::vector<std::string> updateWarnings(const UpdatedCase& made) {
  std::vector<std::string> warnings = made.update.warnings;
  const double rigid = made.registration->expectedErrorMeanMm;
  if (!made.update.converged && rigid > 0 && made.expectedErrorMeanMm > rigid)
    warnings.push_back(
        tr("The update expects to err by %1, the registration by %2: the scan does not tell this "
           "bending; stay with the registration, or scan more of the surface.")
            .arg(mm(made.expectedErrorMeanMm), mm(rigid))
            .toStdString());
  return warnings;
}

}  // namespace falciform
