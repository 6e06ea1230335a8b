#pragma once
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

/// The seeds of --seed, then those of the file of --seeds; patient LPS mm. Throws InputError if a text is no
/// list of places.
[[nodiscard]] Points seedsOf(const ParsedArguments& arguments, CommandRun& run);

}  // namespace falciform::commandline
