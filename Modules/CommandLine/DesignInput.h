#pragma once
#include <string>

#include "Logic/Atlas/AtlasDesign.h"
#include "Modules/CommandLine/CommandRun.h"

namespace falciform::commandline {

/// The presets' names as a list in words, for help and messages.
[[nodiscard]] std::string atlasPresetsText();

/// A preset by its name, or a JSON file. What names no seed takes the run's; the run's becomes the design's.
/// Throws InputError that names the file.
[[nodiscard]] AtlasDesign readDesign(const std::string& text, CommandRun& run);

}  // namespace falciform::commandline
