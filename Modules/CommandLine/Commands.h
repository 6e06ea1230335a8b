#pragma once
#include <string>
#include <vector>

#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

/// One word after `falciform`, or two as in `falciform atlas build`: what it takes and what it does.
struct Command {
  std::string name, title, summary;
  void (*declare)(Syntax& syntax) = nullptr;
  void (*run)(const ParsedArguments& arguments, CommandRun& run) = nullptr;
};

[[nodiscard]] Command segmentCommand();
[[nodiscard]] Command importCommand();
[[nodiscard]] Command scanCommand();
[[nodiscard]] Command smoothCommand();
[[nodiscard]] Command patchesCommand();
[[nodiscard]] Command suggestCommand();
[[nodiscard]] Command registerCommand();
[[nodiscard]] Command distanceCommand();
[[nodiscard]] Command normaliseCommand();
[[nodiscard]] Command cohortCommand();
[[nodiscard]] Command runCommand();
[[nodiscard]] Command demoCommand();
[[nodiscard]] Command synthesiseCommand();
[[nodiscard]] Command trialsCommand();
[[nodiscard]] Command meshCommand();
[[nodiscard]] Command atlasBuildCommand();
[[nodiscard]] Command atlasInfoCommand();
[[nodiscard]] Command updateCommand();
[[nodiscard]] Command locateCommand();
[[nodiscard]] Command fiducialsCommand();
[[nodiscard]] Command infoCommand();

/// All of them, in the order of the work.
[[nodiscard]] const std::vector<Command>& commands();

/// What the command takes, the arguments of every command included.
[[nodiscard]] Syntax syntaxOf(const Command& command);

}  // namespace falciform::commandline
