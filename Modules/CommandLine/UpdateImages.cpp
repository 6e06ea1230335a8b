#include "Modules/CommandLine/UpdateImages.h"

#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Core/Errors.h"
#include "Logic/IO/DisplacementFiles.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/MeshFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/ToolTips.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

constexpr char kMesh[] = "updated_mesh.vtu";

/// ".nii.gz" of "ct.nii.gz"; a format of two files becomes its like in one.
std::string extensionLike(const fs::path& file) {
  const std::string name = lowerCase(file.filename().string());
  for (const char* whole : {".nii.gz", ".seg.nrrd", ".nii", ".nrrd", ".mha"})
    if (name.ends_with(whole)) return whole;
  if (name.ends_with(".nhdr")) return ".nrrd";
  if (name.ends_with(".mhd")) return ".mha";
  return ".nii.gz";
}

struct Place {
  fs::path file;
  bool moved;  ///< into the scan's frame
};

/// "ct_updated.nii.gz" and "ct_bent_preop.nii.gz", as asked for.
std::vector<Place> placesOf(const char* stem, const fs::path& source, ImageFrame frame,
                            const fs::path& folder) {
  std::vector<Place> places;
  const std::string extension = extensionLike(source);
  if (source.empty()) return places;
  if (frame != ImageFrame::Preop) places.push_back({folder / (stem + ("_updated" + extension)), true});
  if (frame != ImageFrame::Scan) places.push_back({folder / (stem + ("_bent_preop" + extension)), false});
  return places;
}

template <class T>
void needLiver(const Volume<T>& volume, const TetrahedralMesh& mesh, const fs::path& file, CommandRun& run) {
  const Matrix4d indexFromWorld = volume.worldFromIndex.inverse();
  Index inside = 0;
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const Vector3d index =
        (indexFromWorld * Vector3d(mesh.points.row(n).transpose()).homogeneous()).head<3>();
    const auto last = volume.size.array().template cast<double>() - 0.5;
    inside += (index.array() >= -0.5).all() && (index.array() <= last).all() ? 1 : 0;
  }
  const std::string name = isVolumeFile(file) ? "'" + file.filename().string() + "'" : "the DICOM series";
  if (inside == 0)
    throw InputError(name +
                     " holds no part of the liver: the two are of different patients or frames; "
                     "give the volume that the surface was made of");
  if (inside < mesh.nodes())
    run.warn(name + " holds " +
             fixed(100 * static_cast<double>(inside) / static_cast<double>(mesh.nodes()), 0) +
             " % of the liver; the rest is background where it has moved");
}

void writeMovedMesh(const UpdateMap& map, const TetrahedralMesh& mesh, const Points& displacements,
                    const std::string& scanFrame, const fs::path& file) {
  TetrahedralMesh moved = mesh;
  moved.points = transformed(mesh.points + displacements, map.scanFromPreop());
  moved.frame = scanFrame;
  const Points turned = displacements * map.scanFromPreop().linear().transpose();
  writeMesh(file, moved, Overwrite::Replace,
            {.cells = {{"min_det_j", leastDetJ(mesh, displacements)}},
             .nodes = {{"preop_mm", mesh.points}, {"displacement_mm", turned}},
             .mayBeFolded = true});
}

/// The grid of the CT or the label map at the spacing asked for; without them a box around the liver and the
/// margin.
SampledGrid displacementGrid(const ImageOutputsPlan& plan, const UpdateMap& map,
                             const std::optional<SampledGrid>& volume) {
  if (volume) {
    const SampledGrid around = gridAroundLiver(map, volume->size, volume->worldFromIndex);
    return coarserGrid(around.size, around.worldFromIndex, plan.gridSpacingMm);
  }
  const double spacing = plan.gridSpacingMm > 0 ? plan.gridSpacingMm : 3;
  const Vector3d low = map.deformed().lowest().array() - map.marginMm(),
                 high = map.deformed().highest().array() + map.marginMm();
  SampledGrid grid;
  grid.size = ((high - low) / spacing).array().ceil().cast<int>() + 1;
  grid.worldFromIndex.topLeftCorner<3, 3>() *= spacing;
  grid.worldFromIndex.topRightCorner<3, 1>() = low;
  return grid;
}

}  // namespace

void declareImageFrame(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "images-in",
              .kind = Choice,
              .label = "Images in",
              .help = "scan: as *_updated, where the liver is now; preop: as *_bent_preop, bent only, to lie "
                      "over the CT as it was; or both.",
              .fallback = "scan",
              .choices = {"scan", "preop", "both"},
              .group = group});
  syntax.add({.name = "grid-spacing",
              .kind = Number,
              .label = "Grid spacing",
              .unit = "mm",
              .help = "Of the displacement grid, about; 0: every voxel of the CT.",
              .fallback = "3",
              .min = 0,
              .max = 100,
              .group = group});
}

void readImageFrame(const ParsedArguments& arguments, ImageFrame& frame, double& gridSpacingMm) {
  gridSpacingMm = parseNumber("--grid-spacing", arguments.text("grid-spacing"));
  frame = enumFromString<ImageFrame>("--images-in", arguments.text("images-in"));
}

void declareUpdateImages(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "ct",
              .kind = File,
              .label = "CT",
              .help = "The CT, pre-op frame (NIfTI, NRRD, MetaImage, DICOM folder): written as it would look "
                      "now, ct_updated.*.",
              .group = group});
  declareSeries(syntax, group, "that is the CT");
  syntax.add({.name = "labels",
              .kind = LabelMap,
              .label = "Label map",
              .help = "The label map, pre-op frame: written as it would look now, labels_updated.*.",
              .group = group});
  declareImageFrame(syntax, group);
  syntax.add({.name = "grid",
              .kind = File,
              .label = "Displacement grid",
              .help =
                  "To write, .nrrd, .nii or .nii.gz: the bending on the CT's grid, in the pre-op frame, as "
                  "3D Slicer's grid transforms are (vectors lead back). The rigid part is "
                  "scan_from_preop.tfm.",
              .output = true,
              .group = group});
  syntax.add({.name = "tool-tips",
              .kind = File,
              .label = "Tool tips",
              .help =
                  "Points in scan mm (.mrk.json, .fcsv, .csv): written as tool_tips_preop.*, where they are "
                  "in the pre-op CT.",
              .group = group});
}

ImageOutputsPlan imageOutputs(const ParsedArguments& arguments) {
  ImageOutputsPlan plan{.ct = arguments.path("ct"),
                        .labels = arguments.path("labels"),
                        .series = arguments.text("series"),
                        .grid = arguments.path("grid"),
                        .toolTips = arguments.path("tool-tips")};
  readImageFrame(arguments, plan.frame, plan.gridSpacingMm);
  if (!plan.grid.empty() && !isDisplacementFile(plan.grid))
    throw InputError("--grid is '" + plan.grid.string() +
                     "'; displacements are written as .nrrd, .nii or .nii.gz");
  return plan;
}

void announceImages(const ImageOutputsPlan& plan, const fs::path& folder, CommandRun& run) {
  run.outputs.announce(folder / kMesh);
  for (const Place& place : placesOf("ct", plan.ct, plan.frame, folder)) run.outputs.announce(place.file);
  for (const Place& place : placesOf("labels", plan.labels, plan.frame, folder))
    run.outputs.announce(place.file);
  if (!plan.grid.empty()) run.outputs.announce(plan.grid);
  if (!plan.toolTips.empty())
    for (const std::string& name : toolTipFiles()) run.outputs.announce(folder / name);
}

BentCt writeImages(const ImageOutputsPlan& plan, const UpdateMap& map, const TetrahedralMesh& mesh,
                   const Points& displacements, const std::string& scanFrame, const fs::path& folder,
                   CommandRun& run, const Progress& progress) {
  const auto describe = [&](const Place& place, const std::string& what) {
    run.frames[place.file.filename().string()] =
        what + (place.moved ? ", in the scan's frame" : ", bent only, in the pre-op frame (patient LPS)") +
        ", mm";
  };
  writeMovedMesh(map, mesh, displacements, scanFrame, run.outputs.staged(folder / kMesh));
  run.frames[kMesh] = "the tetrahedra where they are now, in the scan's frame, mm";
  BentCt bent;
  std::optional<SampledGrid> volume;
  if (!plan.labels.empty()) {
    const falciform::LabelMap labels = run.labelMap(plan.labels);
    needLiver(labels, mesh, plan.labels, run);
    volume = SampledGrid{labels.size, labels.worldFromIndex};
    const falciform::LabelMap now = bendLabels(map, labels, progress.part(0, 0.3));
    for (const Place& place : placesOf("labels", plan.labels, plan.frame, folder)) {
      describe(place, "the label map as it would look now");
      writeLabelMap(run.outputs.staged(place.file), place.moved ? movedVolume(now, map.scanFromPreop()) : now,
                    Overwrite::Replace);
    }
  }
  if (!plan.ct.empty()) {
    bent.before = std::make_shared<const Image>(run.image(plan.ct, plan.series));
    needLiver(*bent.before, mesh, plan.ct, run);
    volume = SampledGrid{bent.before->size, bent.before->worldFromIndex};
    const float background = backgroundOf(*bent.before);
    bent.after =
        std::make_shared<const Image>(bendImage(map, *bent.before, background, progress.part(0.3, 0.7)));
    run.figures["ct_background"] = background;
    for (const Place& place : placesOf("ct", plan.ct, plan.frame, folder)) {
      describe(place, "the CT as it would look now");
      writeImage(run.outputs.staged(place.file),
                 place.moved ? movedVolume(*bent.after, map.scanFromPreop()) : *bent.after,
                 Overwrite::Replace);
    }
  }
  if (!plan.grid.empty()) {
    const SampledGrid grid = displacementGrid(plan, map, volume);
    writeDisplacements(run.outputs.staged(plan.grid),
                       sampleDisplacements(map, grid.size, grid.worldFromIndex, progress.part(0.7, 1)),
                       Overwrite::Replace);
    run.frames[plan.grid.filename().string()] =
        "pre-op frame, rigid motion apart: at a place where tissue is when bent, the vector in mm that leads "
        "to "
        "where it was (resampling direction; LPS in .nrrd, RAS in .nii)";
    run.figures["displacement_margin_mm"] = map.marginMm();
  }
  if (!plan.toolTips.empty()) writeToolTips(plan.toolTips, map, mesh.frame, folder, run);
  return bent;
}

}  // namespace falciform::commandline
