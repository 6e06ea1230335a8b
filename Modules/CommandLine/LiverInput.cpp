#include "Modules/CommandLine/LiverInput.h"

#include <sstream>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Errors.h"

namespace falciform::commandline {

void declareLiverInput(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "preop",
              .kind = Surface,
              .label = "Pre-operative surface",
              .help = "Closed surface of the liver, mm; its falciform patch parts the lobes.",
              .group = group});
  syntax.add(
      {.name = "mesh",
       .kind = File,
       .label = "Mesh",
       .help = "Tetrahedra of the liver as falciform mesh writes them, .vtu; else one is made of --preop.",
       .group = group});
  syntax.add({.name = "tumours",
              .kind = Text,
              .label = "Tumours",
              .help = "Closed surfaces, comma-separated: regions 1, 2, ... of the mesh that is made.",
              .group = group});
}

LiverInput readLiverInput(const ParsedArguments& arguments, CommandRun& run, const Progress& progress,
                          const MeshSettings& meshing) {
  const bool preop = arguments.has("preop"), mesh = arguments.has("mesh"), tumours = arguments.has("tumours");
  if (!preop && !mesh)
    throw InputError(
        "neither --preop nor --mesh is given; give the liver's surface, or its tetrahedra, or both");
  if (mesh && tumours)
    throw InputError(
        "--tumours and --mesh are given; the mesh's own regions are its tumours, so leave one out");
  LiverInput input;
  progress.report(0, "Reading");
  if (preop) input.surface = run.surface(arguments.path("preop"));
  if (mesh) {
    input.mesh = run.tetrahedra(arguments.path("mesh"));
    if (!preop) {
      input.surface = boundarySurface(input.mesh, boundaryFaces(input.mesh)).surface;
      input.surface.frame = input.mesh.frame;
    }
    if (input.surface.frame != input.mesh.frame)
      throw InputError("the surface is in frame " + input.surface.frame + ", the mesh in " +
                       input.mesh.frame + "; bring both into one frame");
    return input;
  }
  const auto settings = arguments.settings(meshing);
  run.settings["mesh"] = settingsToJson(settings);
  std::vector<falciform::Surface> inside;
  std::istringstream names(arguments.text("tumours"));
  for (std::string name; std::getline(names, name, ',');)
    if (!name.empty()) inside.push_back(run.surface(name));
  LiverMesh made = meshLiver(input.surface, inside, settings, progress);
  for (const std::string& repair : made.report.repairs) run.warn("repaired: " + repair);
  run.warn(made.report.warnings);
  input.mesh = std::move(made.mesh);
  return input;
}

}  // namespace falciform::commandline
