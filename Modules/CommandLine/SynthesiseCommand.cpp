#include "Logic/Core/Errors.h"
#include "Modules/CommandLine/BuiltInCase.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PhantomExperiment.h"

namespace falciform::commandline {

namespace {

constexpr char kDeformationGroup[] = "Change between CT and scan (liver only)";
constexpr char kPhantomGroup[] = "Phantom (phantom only)";

void declare(Syntax& syntax) {
  syntax.add({.name = "out",
              .kind = ArgumentKind::Folder,
              .label = "Case folder",
              .help = "Receives a case that `falciform run` takes: CT, label map, painted surface, scan, "
                      "landmarks, targets and truth.",
              .required = true,
              .output = true,
              .group = "Files"});
  syntax.add({.name = "kind",
              .kind = ArgumentKind::Choice,
              .label = "Kind",
              .help = "liver: a deformed liver, its structures and a scan; phantom: the rigid silicone liver "
                      "with seven spheres of thesis ch. III, whose defaults differ where the thesis's counts "
                      "ask for it (edge length 1, voxel 1.09, scanner).",
              .fallback = "liver",
              .choices = {"liver", "phantom"},
              .group = "Files"});
  syntax.addSettings(SyntheticLiverSettings{}, "Liver");
  syntax.addSettings(SyntheticDeformationSettings{}, kDeformationGroup);
  syntax.rename("rms", "deformation");
  syntax.addSettings(PackingSettings{}, kDeformationGroup);
  syntax.addSettings(TouchSettings{}, kDeformationGroup);
  syntax.addSettings(VirtualScannerSettings{}, "Scanner");
  syntax.addSettings(ScanFaultSettings{}, "Operating room");
  syntax.addSettings(PhantomSettings{}, kPhantomGroup);
}

/// What belongs to the other kind is refused, not passed over.
void refuseGroup(const ParsedArguments& arguments, const std::string& group, const std::string& kind) {
  const Syntax syntax = syntaxOf(synthesiseCommand());
  for (const Argument& argument : syntax.arguments())
    if (argument.group == group && arguments.has(argument.name))
      throw InputError("--" + argument.name + " has no meaning for --kind " + kind + "; leave it out");
}

void makeLiver(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out"), sidecar = folder / "synthesise.json";
  BuiltInCaseSettings settings;
  settings.faults = arguments.settings(settings.faults);
  for (const auto& file : builtInCaseFiles(folder, settings.faults)) run.outputs.announce(file);
  run.outputs.announce(sidecar);
  settings.liver = arguments.settings(settings.liver);
  settings.deformation = arguments.settings(settings.deformation);
  settings.packing = arguments.settings(settings.packing);
  settings.touch = arguments.settings(settings.touch);
  settings.scanner = arguments.settings(settings.scanner);
  run.settings = {
      {"liver", settingsToJson(settings.liver)},     {"deformation", settingsToJson(settings.deformation)},
      {"packing", settingsToJson(settings.packing)}, {"landmarks", settingsToJson(settings.touch)},
      {"scanner", settingsToJson(settings.scanner)}, {"room", settingsToJson(settings.faults)}};
  const BuiltInCase made = makeBuiltInCase(settings, run.progress.part(0, 0.9));
  run.frames = {{"ct.nii.gz, labelmap.nii.gz, preop_painted.vtp, structures, targets", "patient LPS, mm"},
                {"scan.vtp, scan_landmarks, truth_targets", "scanner, mm"},
                {"truth_scan_from_preop.tfm", "maps pre-op LPS mm to scan mm"}};
  run.figures = {{"vertices", made.liver.surface.size()},
                 {"scan_points", made.scan.scan.size()},
                 {"coverage", made.scan.coverage}};
  run.progress.report(0.9, "Writing");
  writeBuiltInCase(made, folder, run.outputs);
  run.writeSidecar(sidecar);
  run.say("liver of " + std::to_string(made.liver.surface.size()) + " points, scan of " +
          std::to_string(made.scan.scan.size()) + " points that covers " +
          fixed(100 * made.scan.coverage, 1) + " %");
}

void makePhantom(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out"), sidecar = folder / "synthesise.json";
  PhantomPlan plan = thesisPhantom();
  plan.liver = arguments.settings(plan.liver);
  plan.scanner = arguments.settings(plan.scanner);
  plan.phantom = arguments.settings(plan.phantom);
  plan.faults = arguments.settings(plan.faults);
  for (const auto& file : phantomFiles(folder, plan)) run.outputs.announce(file);
  for (const auto& file : phantomPictures(folder)) run.outputs.announce(file);
  run.outputs.announce(sidecar);
  run.settings = {{"kind", "phantom"},
                  {"liver", settingsToJson(plan.liver)},
                  {"scanner", settingsToJson(plan.scanner)},
                  {"phantom", settingsToJson(plan.phantom)},
                  {"room", settingsToJson(plan.faults)}};
  const PhantomExperiment made = makePhantomExperiment(plan, run.progress.part(0, 0.8));
  run.frames = {{"ct.nii.gz, labelmap.nii.gz, preop.vtp, spheres_ct, targets", "patient LPS, mm"},
                {"scan*.vtp, spheres_scan, truth_targets", "scanner, mm"},
                {"gold_scan_from_preop.tfm, truth_scan_from_preop.tfm", "map pre-op LPS mm to scan mm"}};
  run.figures = phantomFigures(made);
  run.progress.report(0.8, "Writing");
  writePhantom(made, folder, run.outputs);
  run.progress.report(0.9, "Drawing");
  writePhantomPictures(made, folder, run.outputs);
  run.writeSidecar(sidecar);
  for (const auto& [name, surface] : {std::pair("CT surface", &made.preop),
                                      {"whole scan", &made.made.scan},
                                      {"sub-region", &made.made.subRegion}})
    run.say(std::string(name) + ": " + std::to_string(surface->size()) + " points, falciform " +
            std::to_string(pointsOfPatch(*surface, patch::kFalciform).size()) + ", inferior ridge " +
            std::to_string(pointsOfPatch(*surface, patch::kInferiorRidge).size()));
  run.say("spheres: FRE " + fixed(made.gold.freMm, 3) + " mm; located within " +
          fixed(made.sphereErrorCtMm.maxCoeff(), 3) + " mm in the CT, " +
          fixed(made.sphereErrorScanMm.maxCoeff(), 3) + " mm in the scan");
  if (made.beadErrorMm.size() > 0)
    run.say("beads in the CT: " + std::to_string(made.made.beadsCt.points.size()) + " of " +
            std::to_string(made.beadErrorMm.size()) + ", mean " + fixed(made.beadErrorMm.mean(), 3) +
            " mm, largest " + fixed(made.beadErrorMm.maxCoeff(), 3) + " mm");
  run.say("gold standard: target error mean " + fixed(made.goldTargetErrorMm.mean(), 3) + " mm, largest " +
          fixed(made.goldTargetErrorMm.maxCoeff(), 3) + " mm; expected " +
          fixed(made.predictedTargetErrorMm.mean(), 3) + " mm");
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const bool phantom = arguments.text("kind") == "phantom";
  refuseGroup(arguments, phantom ? kDeformationGroup : kPhantomGroup, phantom ? "phantom" : "liver");
  (phantom ? makePhantom : makeLiver)(arguments, run);
  const std::filesystem::path folder = arguments.path("out");
  run.say("written to " + folder.string() + "; falciform run " + folder.string() + " --out DIR registers it");
}

}  // namespace

Command synthesiseCommand() {
  return {"synthesise", "Synthetic case",
          "Makes a synthetic liver or the phantom of the thesis, and a scan of it, with known truth.",
          declare, execute};
}

}  // namespace falciform::commandline
