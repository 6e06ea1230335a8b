#include "Modules/CommandLine/UpdateInput.h"

#include <sstream>

#include "Logic/Core/Errors.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

void declareUpdateInput(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "scan",
              .kind = Surface,
              .label = "Scan",
              .help = "Surface or point cloud in the scanner's frame, mm.",
              .required = true,
              .group = group});
  syntax.add(
      {.name = "structures",
       .kind = Text,
       .label = "Structures",
       .help = "Surfaces of vessels and tumours, pre-op mm, comma-separated: written where they are now.",
       .group = group});
  syntax.add({.name = "targets",
              .kind = Points,
              .label = "Targets",
              .help = "Points inside the liver, pre-op mm: written where they are now.",
              .group = group});
  syntax.add({.name = "truth-targets",
              .kind = Points,
              .label = "True targets",
              .help = "Where the targets truly are, scan mm, to measure target error.",
              .group = group});
  syntax.add({.name = "init",
              .kind = Text,
              .label = "Rigid pose",
              .help =
                  "Transform file (.tfm, .txt, .json) that maps pre-op mm to scan mm; without it the scan is "
                  "registered first.",
              .group = group});
}

UpdateInput readUpdateInput(const ParsedArguments& arguments, CommandRun& run) {
  if (arguments.has("truth-targets") && !arguments.has("targets"))
    throw InputError("--truth-targets is given without --targets; give both or none");
  UpdateInput input;
  input.scan = run.surface(arguments.path("scan"));
  std::istringstream names(arguments.text("structures"));
  for (std::string name; std::getline(names, name, ',');)
    if (!name.empty()) {
      const std::string stem = fs::path(name).stem().string();
      input.structures.push_back({stem, stem + "_updated.vtp", run.surface(name)});
    }
  if (arguments.has("targets")) input.targets = run.landmarks(arguments.path("targets"));
  if (arguments.has("truth-targets")) input.truth = run.landmarks(arguments.path("truth-targets"));
  input.settings = arguments.settings(UpdateSettings{});
  run.settings["update"] = settingsToJson(input.settings);
  return input;
}

}  // namespace falciform::commandline
