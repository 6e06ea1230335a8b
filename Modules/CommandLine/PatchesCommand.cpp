#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Patches/PatchTransfer.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PatchDelineation.h"
#include "Modules/CommandLine/PatchSettings.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "from",
              .kind = Surface,
              .label = "Painted surface",
              .help = "Surface or scan whose patches are taken.",
              .group = group});
  syntax.add({.name = "to",
              .kind = Surface,
              .label = "Surface to paint",
              .help = "Surface that receives them; same frame as --from.",
              .group = group});
  syntax.add({.name = "out",
              .kind = Surface,
              .label = "Painted result",
              .help = "Where to write it; .vtp, .vtk and .ply keep patches. Its sidecar is written beside it "
                      "as FILE.json.",
              .output = true,
              .group = group});
  syntax.add({.name = "SURFACE",
              .kind = Surface,
              .label = "Surface",
              .help = "Only tell what is painted on this surface or scan.",
              .positional = true,
              .group = group});
  syntax.addSettings(PatchTransferSettings{}, "Transfer");
  declareDelineation(syntax);
}

void tell(const falciform::Surface& surface, CommandRun& run) {
  const std::vector<PatchStatistics> patches = patchStatistics(surface);
  run.figures["patches"] = toJson(patches);
  if (patches.empty()) run.say("no patch is painted");
  for (const PatchStatistics& patch : patches)
    run.say(std::to_string(patch.label) + "  " + patch.name + ": " + std::to_string(patch.points) +
            " points, " + (patch.areaMm2 > 0 ? fixed(patch.areaMm2 / 100, 1) + " cm2, " : "") +
            fixed(patch.lengthMm, 1) + " x " + fixed(patch.widthMm, 1) + " mm, " +
            std::to_string(patch.pieces) + (patch.pieces == 1 ? " piece" : " pieces"));
}

void transfer(const ParsedArguments& arguments, CommandRun& run) {
  for (const char* needed : {"from", "to", "out"})
    if (!arguments.has(needed))
      throw InputError(std::string("--") + needed + " is missing; a transfer needs --from, --to and --out");
  const std::filesystem::path out = arguments.path("out");
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  const auto settings = arguments.settings(PatchTransferSettings{});
  run.settings["patches"] = settingsToJson(settings);
  const falciform::Surface from = run.surface(arguments.path("from"));
  falciform::Surface to = run.surface(arguments.path("to"));
  if (from.frame != to.frame)
    run.warn("the surfaces are in different frames ('" + from.frame + "' and '" + to.frame +
             "'); patches are carried as if they were one");
  if (patchLabels(from).empty())
    throw InputError("'" + arguments.text("from") +
                     "' has no painted patch; paint it first or give another surface");
  to.patch = transferPatches(from, to, settings.radiusMm, settings.keepOld);
  to.patchNames.insert(from.patchNames.begin(), from.patchNames.end());
  for (const int label : patchLabels(from))
    if (pointsOfPatch(to, label).empty())
      run.warn("patch '" + patchName(from, label) + "' reached no point within " +
               fixed(settings.radiusMm, 2) + " mm");
  run.frames = {{out.filename().string(), to.frame}};
  tell(to, run);
  writeSurface(run.outputs.staged(out), to, Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
}

/// Paints --to from the stylus's way or by its own colours.
void delineate(const ParsedArguments& arguments, CommandRun& run) {
  for (const char* needed : {"to", "out"})
    if (!arguments.has(needed))
      throw InputError(std::string("--") + needed +
                       " is missing; --swab and --refine-by-colour paint --to and write --out");
  if (arguments.has("from"))
    throw InputError("--from is given with --swab or --refine-by-colour; give one or the other");
  const std::filesystem::path out = arguments.path("out");
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  falciform::Surface surface = run.surface(arguments.path("to"));
  surface.patch = delineated(surface, arguments, run);
  run.frames = {{out.filename().string(), surface.frame}};
  tell(surface, run);
  writeSurface(run.outputs.staged(out), surface, Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  if (delineationAsked(arguments) && !arguments.has("SURFACE")) return delineate(arguments, run);
  if (!arguments.has("SURFACE")) return transfer(arguments, run);
  for (const char* other : {"from", "to", "out", "swab", "refine-by-colour"})
    if (arguments.has(other))
      throw InputError(std::string("--") + other + " is given with SURFACE; give one or the other");
  tell(run.surface(arguments.path("SURFACE")), run);
}

}  // namespace

Command patchesCommand() {
  return {"patches", "Patches",
          "Tells what is painted on a surface, carries patches from one surface to another, or paints them "
          "by the "
          "stylus or the colours.",
          declare, execute};
}

}  // namespace falciform::commandline
