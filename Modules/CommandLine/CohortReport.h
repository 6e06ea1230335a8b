#pragma once
#include <string>

#include "Logic/Core/Provenance.h"
#include "Logic/Deformation/Cohort/CohortAnalysis.h"
#include "Modules/CommandLine/CohortInput.h"

namespace falciform::commandline {

/// The cards, groups, matrix, cases left out and likenesses of one metric as HTML.
[[nodiscard]] std::string cohortSections(const CohortInput& input, const CohortAnalysis& analysis,
                                         const PermutationSettings& settings, const std::string& matrixSvg);

/// The report of a cohort: one HTML file that links to nothing. Table IV.7's columns with the exact test
/// beside the thesis's, the matrix as a picture, each case left out, and what each case is most alike.
[[nodiscard]] std::string cohortReportHtml(const CohortInput& input, const CohortAnalysis& analysis,
                                           const PermutationSettings& settings, const std::string& matrixSvg,
                                           const Provenance& provenance);

/// "0.23 ± 0.24", "0.35" for one value, "-" for none: as the thesis prints Table IV.7.
[[nodiscard]] std::string meanAndSd(const SampleMoments& moments, int decimals = 2);
/// Three places; "< 0.001" below; "-" for none.
[[nodiscard]] std::string pText(double p);
/// "all 120 arrangements" or "100001 of 1.3e+08 arrangements, drawn with seed 1".
[[nodiscard]] std::string arrangementsText(const PermutationTest& test, int seed);

}  // namespace falciform::commandline
