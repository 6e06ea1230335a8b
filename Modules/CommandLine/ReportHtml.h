#pragma once
#include <string>
#include <vector>

#include "Modules/CommandLine/CaseRun.h"

namespace falciform::commandline {

/// The report of a case run: one HTML file that holds its pictures and links to nothing. Figures with units,
/// warnings in plain words, settings and provenance; residuals are called fit, and target error stands only
/// where there is truth.
[[nodiscard]] std::string reportHtml(const CaseOutcome& outcome, const CaseSettings& settings,
                                     const Provenance& provenance, const std::vector<PictureFile>& pictures,
                                     const std::vector<PictureFile>& updatePictures);

}  // namespace falciform::commandline
