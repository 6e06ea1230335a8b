#pragma once
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

/// Declares --seed and --seeds; `what` says what is clicked at, and in which frame.
void declareSeeds(Syntax& syntax, const std::string& group, const std::string& what);

/// The same as seedsOf with names: "click 1" and up, and the file's own.
[[nodiscard]] Landmarks seedPointsOf(const ParsedArguments& arguments, CommandRun& run);

/// The seeds of --seed, then those of the file of --seeds; mm. Throws InputError if a text is no
/// list of places.
[[nodiscard]] Points seedsOf(const ParsedArguments& arguments, CommandRun& run);

/// The place of one argument, "x,y,z", mm. Throws InputError for anything else.
[[nodiscard]] Vector3d placeOf(const ParsedArguments& arguments, const std::string& name);

}  // namespace falciform::commandline
