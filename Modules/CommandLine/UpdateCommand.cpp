#include "Logic/Patches/PatchStatistics.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/UpdateBasisInput.h"
#include "Modules/CommandLine/UpdateImages.h"
#include "Modules/CommandLine/UpdateInput.h"
#include "Modules/CommandLine/UpdateOutputs.h"

namespace falciform::commandline {
namespace {

/// Coarser than an atlas's: it is made while someone waits, and the fit gains nothing from finer elements.
constexpr MeshSettings kMeshing{.edgeLengthMm = 13};

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  declareLiverInput(syntax, group);
  declareUpdateBasis(syntax, group);
  declareUpdateInput(syntax, group);
  declareUpdateImages(syntax, group);
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives updated.vtp, updated_mesh.vtu, targets_updated.mrk.json, structure surfaces, "
                      "images, the rigid part as scan_from_preop.*, and update.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also draw the liver before and after the update, and its expected error, .png.",
              .output = true,
              .group = group});
  syntax.addSettings(UpdateSettings{}, "Fit");
  syntax.addSettings(kMeshing, "Mesh, where none is given");
  syntax.addResult({"rms_mm", "RMS residual (fit, not target error)", "mm"});
  syntax.addResult({"expected_error_mean_mm", "Expected target error", "mm"});
  syntax.addResult({"target_error_mean_mm", "Mean target error", "mm"});
  syntax.addResult({"min_det_j", "Smallest local ratio of volumes", ""});
}

/// The pose that the update begins from.
RegistrationResult rigidStart(const ParsedArguments& arguments, const falciform::Surface& preop,
                              const falciform::Surface& scan, CommandRun& run, const Progress& progress) {
  RegistrationResult rigid;
  if (arguments.has("init")) {
    rigid.scanFromPreop = run.transform(arguments.text("init"));
    return rigid;
  }
  rigid = registerSurfaces(preop, scan, RegistrationSettings{}, Isometry3d::Identity(), progress);
  run.warn(rigid.warnings);
  return rigid;
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out");
  announceUpdate(arguments, run);
  const ImageOutputsPlan images = imageOutputs(arguments);
  announceImages(images, folder, run);
  const UpdateInput input = readUpdateInput(arguments, run);
  announceStructures(input, folder, run);
  const UpdateBasisInput known = readUpdateBasis(arguments, run, kMeshing, run.progress.part(0, 0.2));
  const LiverInput& liver = known.liver;
  run.warn(patchWarnings(liver.surface, input.scan));

  const PreparedUpdate prepared(known.method, liver.surface, known.basis, run.progress.part(0.2, 0.7));
  const RegistrationResult rigid =
      rigidStart(arguments, liver.surface, input.scan, run, run.progress.part(0.7, 0.8));
  const UpdateResult update = updateByMethod(prepared, input.scan, rigid.scanFromPreop, input.settings,
                                             run.provenance.seed, run.progress.part(0.8, 0.95));
  run.warn(update.warnings);

  const UpdatedLiver updated = updatedLiver(liver, input, rigid, update, prepared.model());
  tellUpdate(updated, run);
  writeUpdate(updated, arguments, run);
  writeImages(images, UpdateMap(liver.mesh, update.displacements, update.scanFromPreop), liver.mesh,
              update.displacements, input.scan.frame, folder, run, run.progress.part(0.95, 1));
  run.writeSidecar(folder / "update.json");
  run.say("written to " + folder.string());
}

}  // namespace

Command updateCommand() {
  return {"update", "Update model",
          "Moves the whole pre-operative liver to where a partial scan shows it to be now, bending included.",
          declare, execute};
}

}  // namespace falciform::commandline
