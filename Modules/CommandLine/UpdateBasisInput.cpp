#include "Modules/CommandLine/UpdateBasisInput.h"

#include "Logic/Atlas/LoadFiles.h"
#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Errors.h"

namespace falciform::commandline {

namespace {

UpdateBasis readBasis(const std::filesystem::path& file) {
  if (atlasKindOf(file) == AtlasKind::SurfaceLoads)
    return std::make_shared<const LoadResponses>(readLoadAtlas(file).atlas.loads);
  return std::make_shared<const Atlas>(readAtlas(file).atlas);
}

}  // namespace

void declareUpdateBasis(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "atlas",
              .kind = File,
              .label = "Atlas",
              .help =
                  "What falciform atlas build solved on this surface, .h5: its mesh is taken, and nothing "
                  "need be solved now. Of surface-loads for 'model' and 'libr'; of deformations for "
                  "'icat', 'icat-star', 'constrained' and 'pca', which cannot do without.",
              .group = group});
  std::vector<std::string> methods;
  for (const std::string_view name : enumNames(UpdateMethod{})) methods.emplace_back(name);
  syntax.add({.name = "method",
              .kind = Choice,
              .label = "Method",
              .help =
                  "model: ours. The others are those of the literature, to compare: icat and icat-star as "
                  "the thesis has them, incremental FEM, constrained inverse, PCA atlas, control points.",
              .fallback = "model",
              .choices = methods,
              .group = group});
}

UpdateBasisInput readUpdateBasis(const ParsedArguments& arguments, CommandRun& run,
                                 const MeshSettings& meshing, const Progress& progress) {
  UpdateBasisInput input;
  input.method = enumFromString<UpdateMethod>("--method", arguments.text("method"));
  run.settings["method"] = enumToString(input.method);
  if (!arguments.has("atlas")) {
    if (needsDeformations(input.method))
      throw InputError("--method is " + enumToString(input.method) +
                       " and no --atlas is given; it needs one of deformations: build one (falciform atlas "
                       "build thesis-packing)");
    input.liver = readLiverInput(arguments, run, progress, meshing);
    input.basis = std::make_shared<const TetrahedralMesh>(input.liver.mesh);
    return input;
  }
  for (const char* other : {"mesh", "tumours"})
    if (arguments.has(other))
      throw InputError("--atlas and --" + std::string(other) +
                       " are given; the atlas has its own mesh, so leave one out");
  progress.report(0, "Reading the atlas");
  const std::filesystem::path file = arguments.path("atlas");
  input.basis = readBasis(file);
  run.remember(file);
  input.liver.mesh = meshOf(input.basis);
  if (arguments.has("preop")) {
    input.liver.surface = run.surface(arguments.path("preop"));
  } else {
    input.liver.surface = boundarySurface(input.liver.mesh, boundaryFaces(input.liver.mesh)).surface;
    input.liver.surface.frame = input.liver.mesh.frame;
  }
  return input;
}

}  // namespace falciform::commandline
