#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Core/Provenance.h"
#include "Modules/CommandLine/TrialOutcome.h"

namespace falciform::commandline {

/// Histograms of the RMS residual and, where there are targets, of the target error (thesis Figs. III.8,
/// III.9, III.16), as SVG.
struct TrialHistograms {
  std::string rms, targetError;
};
[[nodiscard]] TrialHistograms trialHistograms(const TrialOutcome& outcome);

/// The report: one HTML file that holds its figures and links to nothing.
[[nodiscard]] std::string trialReportHtml(const TrialOutcome& outcome, const TrialHistograms& histograms,
                                          const Provenance& provenance);

}  // namespace falciform::commandline
