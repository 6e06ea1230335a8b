#pragma once
#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

// `falciform patches` with a tracked stylus or with the camera's colours in place of a painted surface.

/// --swab, --refine-by-colour, --label and the settings of both.
void declareDelineation(Syntax& syntax);
[[nodiscard]] bool delineationAsked(const ParsedArguments& arguments);
/// The labels of `surface` with the swab's patch painted and the label's patch refined, as asked; tells what
/// was done in figures and warnings.
[[nodiscard]] std::vector<int> delineated(const Surface& surface, const ParsedArguments& arguments,
                                          CommandRun& run);

}  // namespace falciform::commandline
