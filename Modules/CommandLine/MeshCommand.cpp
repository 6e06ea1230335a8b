#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/IO/MeshFiles.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/MeshPicture.h"
#include "Modules/CommandLine/PictureTiles.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "preop",
              .kind = Surface,
              .label = "Pre-operative surface",
              .help = "Closed surface of the liver, mm.",
              .required = true,
              .group = group});
  syntax.add({.name = "tumours",
              .kind = Text,
              .label = "Tumours",
              .help = "Closed surfaces, comma-separated: regions 1, 2, ... of the mesh, in this order.",
              .group = group});
  syntax.add({.name = "out",
              .kind = File,
              .label = "Mesh",
              .help = "Mesh to write, .vtu; its sidecar is written beside it as FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also write a picture of the mesh cut open, .png.",
              .output = true,
              .group = group});
  syntax.addSettings(MeshSettings{}, "Mesh");
  syntax.addResult({"elements", "Elements", ""});
  syntax.addResult({"nodes", "Nodes", ""});
  syntax.addResult({"volume_mm3", "Volume", "mm3"});
}

std::vector<std::filesystem::path> filesIn(const std::string& list) {
  std::vector<std::filesystem::path> files;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (end > begin) files.emplace_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return files;
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out");
  if (out.extension() != ".vtu")
    throw InputError("--out is '" + out.string() + "'; a tetrahedral mesh is written as .vtu");
  const std::filesystem::path picture = picturePath(arguments);
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  if (!picture.empty()) run.outputs.announce(picture);
  const auto settings = arguments.settings(MeshSettings{});
  run.settings["mesh"] = settingsToJson(settings);

  run.progress.report(0, "Reading the surfaces");
  const falciform::Surface preop = run.surface(arguments.path("preop"));
  std::vector<falciform::Surface> tumours;
  for (const auto& file : filesIn(arguments.text("tumours"))) {
    tumours.push_back(run.surface(file));
    if (tumours.back().frame != preop.frame)
      throw InputError("'" + file.filename().string() + "' is in frame " + tumours.back().frame +
                       ", the liver in " + preop.frame + "; bring both into one frame");
  }
  const LiverMesh made = meshLiver(preop, tumours, settings, run.progress.part(0.05, 0.9));
  const MeshReport& report = made.report;
  for (const std::string& repair : report.repairs) run.warn("repaired: " + repair);
  run.warn(report.warnings);
  run.figures = toJson(report);
  run.frames = {{out.filename().string(), preop.frame == "LPS" ? "patient LPS, mm" : preop.frame + ", mm"}};
  run.progress.report(0.9, "Writing");
  writeMesh(run.outputs.staged(out), made.mesh, Overwrite::Replace);
  if (!picture.empty()) saveMeshPicture(made.mesh, run.outputs.staged(picture), Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
  run.say(out.string() + ": " + std::to_string(report.elements) + " " +
          (made.mesh.quadratic() ? "quadratic" : "linear") + " tetrahedra, " + std::to_string(report.nodes) +
          " nodes, " + std::to_string(report.degreesOfFreedom) + " degrees of freedom");
  run.say(fixed(report.volumeMm3 / 1000, 1) + " ml of " + fixed(report.inputVolumeMm3 / 1000, 1) +
          " ml; boundary " + fixed(report.meanDistanceMm, 2) + " mm from the surface on average, " +
          fixed(report.maxDistanceMm, 2) + " mm at most; smallest dihedral angle " +
          fixed(report.minDihedralDeg, 1) + " deg, median " + fixed(report.medianDihedralDeg, 1) + " deg");
  for (const MeshRegion& region : report.regions)
    if (region.number > 0)
      run.say("tumour " + std::to_string(region.number) + ": " + std::to_string(region.elements) +
              " elements, " + fixed(region.volumeMm3 / 1000, 2) + " ml of " +
              fixed(region.wantedMm3 / 1000, 2) + " ml" +
              (region.conforming ? "" : ", by the elements' centres"));
}

}  // namespace

Command meshCommand() {
  return {"mesh", "Tetrahedral mesh", "Fills the liver with tetrahedra, tumours as regions.", declare,
          execute};
}

}  // namespace falciform::commandline
