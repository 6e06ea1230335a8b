#pragma once
#include <string>

#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"
#include "Modules/CommandLine/TrialOutcome.h"

namespace falciform::commandline {

/// The files that trials take.
void declareTrialFiles(Syntax& syntax, const std::string& group);

/// Refuses combinations of target arguments that make no sense, before anything is read.
void checkTargetArguments(const ParsedArguments& arguments);
/// --targets with --truth-targets, or --truth, or none.
[[nodiscard]] TrialTargets readTrialTargets(const ParsedArguments& arguments, CommandRun& run);
/// "small", "large", or a JSON file {"rotationDeg": ..., "translationMm": ...}.
[[nodiscard]] TrialScale readTrialScale(const std::string& text, CommandRun& run);

}  // namespace falciform::commandline
