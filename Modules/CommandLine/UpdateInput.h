#pragma once
#include <string>
#include <vector>

#include "Logic/Atlas/UpdateSettings.h"
#include "Logic/Core/Landmarks.h"
#include "Logic/Core/Surface.h"
#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

/// What `falciform update` is told of the scan's side and wants moved; the liver is read by readLiverInput.
struct UpdateInput {
  struct Structure {
    std::string name, file;  ///< as it is called, and to be written
    falciform::Surface surface;
  };
  falciform::Surface scan;
  std::vector<Structure> structures;
  Landmarks targets, truth;  ///< without points where none are given
  UpdateSettings settings;
};

void declareUpdateInput(Syntax& syntax, const std::string& group);

/// Throws InputError for true targets without targets.
[[nodiscard]] UpdateInput readUpdateInput(const ParsedArguments& arguments, CommandRun& run);

}  // namespace falciform::commandline
