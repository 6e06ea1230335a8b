#include "Modules/CommandLine/PatchDelineation.h"

#include "Logic/IO/TrackedPointFiles.h"
#include "Logic/Patches/ColourPatch.h"
#include "Logic/Patches/SwabPatch.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace {

void paintSwab(Surface& surface, int label, const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path file = arguments.path("swab");
  const auto settings = arguments.settings(SwabSettings{});
  run.settings["swab"] = settingsToJson(settings);
  const Loaded<TrackedPoints> read = readTrackedPoints(file);
  run.remember(file);
  run.warn(read.warnings);
  const SwabPatch patch = patchOfSwab(surface, read.value, settings);
  run.warn(patch.warnings);
  for (const int v : patch.vertices) surface.patch[static_cast<std::size_t>(v)] = label;
  run.figures["swab"] = {{"points_used", patch.used},
                         {"points_lifted_off", patch.liftedOff},
                         {"points_astray", patch.outliers},
                         {"samples_lost", read.value.lost},
                         {"way_mm", patch.lengthMm}};
  run.say("swab: " + std::to_string(patch.used) + " points used, " + std::to_string(patch.liftedOff) +
          " lifted off, " + std::to_string(patch.outliers) + " astray, a way of " + fixed(patch.lengthMm, 0) +
          " mm");
}

void refine(Surface& surface, int label, const ParsedArguments& arguments, CommandRun& run) {
  const auto settings = arguments.settings(ColourPatchSettings{});
  run.settings["colour"] = settingsToJson(settings);
  const ColourPatch patch = refinePatchByColour(surface, label, settings);
  run.warn(patch.warnings);
  const std::vector<int> rough = pointsOfPatch(surface, label);
  for (const int v : rough) surface.patch[static_cast<std::size_t>(v)] = patch::kNone;
  for (const int v : patch.vertices) surface.patch[static_cast<std::size_t>(v)] = label;
  run.figures["colour"] = {{"points_before", rough.size()},
                           {"points_after", patch.vertices.size()},
                           {"contrast", patch.contrast},
                           {"rounds", patch.rounds},
                           {"refined", patch.refined}};
  run.say("colour: " + std::to_string(rough.size()) + " points before, " +
          std::to_string(patch.vertices.size()) + " after, contrast " + fixed(patch.contrast, 1));
}

}  // namespace

void declareDelineation(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "From the stylus or the colours (with --to and --out)";
  syntax.add(
      {.name = "swab",
       .kind = File,
       .label = "Swab",
       .help =
           "Tracked way of the stylus over the surface, .csv with columns x, y, z in the surface's frame; "
           "its patch is painted.",
       .group = group});
  syntax.add(
      {.name = "refine-by-colour",
       .kind = Flag,
       .label = "Refine by colour",
       .help = "The patch of --label, painted roughly or by --swab, is fitted to the colours of the scan.",
       .group = group});
  syntax.add({.name = "label",
              .kind = Integer,
              .label = "Label",
              .help = "Of the patch: 1 falciform, 2 inferior ridge, 3 and up as named.",
              .fallback = "1",
              .min = 1,
              .max = patch::kMax,
              .group = group});
  syntax.addSettings(SwabSettings{}, group);
  syntax.addSettings(ColourPatchSettings{}, group);
}

bool delineationAsked(const ParsedArguments& arguments) {
  return arguments.has("swab") || arguments.has("refine-by-colour");
}

std::vector<int> delineated(const Surface& surface, const ParsedArguments& arguments, CommandRun& run) {
  Surface painted = surface;
  if (painted.patch.empty()) painted.patch.assign(static_cast<std::size_t>(painted.size()), patch::kNone);
  const int label = arguments.integer("label");
  if (arguments.has("swab")) paintSwab(painted, label, arguments, run);
  if (arguments.has("refine-by-colour")) refine(painted, label, arguments, run);
  return painted.patch;
}

}  // namespace falciform::commandline
