#pragma once
#include <string>

#include "Logic/Deformation/Cohort/Cohort.h"

namespace falciform::commandline {

/// The correlation matrix as coloured squares with their numbers: blue for -1, white for 0, orange for 1,
/// colours that the colour-blind tell apart. Cases stand by group, each group framed and named; those in none
/// come last. One SVG document that is also fit to stand in a page. Texts are escaped.
[[nodiscard]] std::string correlationSvg(const Cohort& cohort);

}  // namespace falciform::commandline
