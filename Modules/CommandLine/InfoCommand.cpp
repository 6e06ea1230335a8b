#include <algorithm>
#include <map>

#include "Logic/Biomechanics/MeshQuality.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/MeshFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

void declare(Syntax& syntax) {
  syntax.add({.name = "FILE",
              .kind = ArgumentKind::File,
              .label = "File",
              .help =
                  "Surface, scan, label map, DICOM folder or file, tetrahedral mesh, landmarks, transform or "
                  "case folder.",
              .required = true,
              .positional = true,
              .group = "Files"});
}

std::string box(const Eigen::Matrix<double, 2, 3>& corners) {
  std::string text = "extent";
  for (int axis = 0; axis < 3; ++axis)
    text += std::string(axis ? " x [" : " [") + fixed(corners(0, axis), 1) + ", " +
            fixed(corners(1, axis), 1) + "]";
  return text + " mm";
}

void tellSurface(const fs::path& file, CommandRun& run) {
  const Surface surface = run.surface(file);
  const bool cloud = surface.triangles.rows() == 0;
  run.say(std::string(cloud ? "point cloud" : "surface") + " of " + std::to_string(surface.size()) +
          " points" + (cloud ? "" : " and " + std::to_string(surface.triangles.rows()) + " triangles") +
          " in frame " + surface.frame);
  run.say(box(boundingBox(surface.points)));
  run.figures = {{"kind", cloud ? "point cloud" : "surface"},
                 {"points", surface.size()},
                 {"triangles", surface.triangles.rows()},
                 {"frame", surface.frame}};
  if (surface.texture)
    run.say("texture of " + std::to_string(surface.texture->width) + " x " +
            std::to_string(surface.texture->height) + " pixels");
  else if (surface.colours.rows() > 0)
    run.say("colours at the points");
  run.figures["colours"] = surface.texture ? "texture" : surface.colours.rows() > 0 ? "points" : "none";
  if (!cloud) {
    const TopologyReport topology = inspectTopology(surface);
    run.say(describeTopology(topology) + "; area " + fixed(area(surface) / 100, 1) + " cm2" +
            (topology.closedManifold() ? ", volume " + fixed(signedVolume(surface) / 1000, 1) + " ml" : ""));
    run.figures["topology"] = describeTopology(topology);
    run.figures["area_mm2"] = area(surface);
    if (topology.closedManifold()) run.figures["volume_mm3"] = signedVolume(surface);
  }
  const auto patches = patchStatistics(surface);
  run.figures["patches"] = toJson(patches);
  for (const PatchStatistics& patch : patches)
    run.say("patch " + std::to_string(patch.label) + " '" + patch.name +
            "': " + std::to_string(patch.points) + " points");
  for (const auto& [name, values] : surface.arrays) run.say("array " + name);
}

void tellVolume(const fs::path& file, CommandRun& run) {
  const LabelMap map = run.labelMap(file);
  const Vector3d spacing = map.spacing();
  run.say("label map of " + std::to_string(map.size.x()) + " x " + std::to_string(map.size.y()) + " x " +
          std::to_string(map.size.z()) + " voxels of " + fixed(spacing.x(), 3) + " x " +
          fixed(spacing.y(), 3) + " x " + fixed(spacing.z(), 3) + " mm");
  run.figures = {{"kind", "label map"},
                 {"size", {map.size.x(), map.size.y(), map.size.z()}},
                 {"spacing_mm", {spacing.x(), spacing.y(), spacing.z()}},
                 {"labels", nlohmann::json::array()}};
  for (const auto& [label, count] : labelCounts(map)) {
    const double volume = static_cast<double>(count) * map.voxelVolume();
    run.say("label " + std::to_string(label) + ": " + std::to_string(count) + " voxels, " +
            fixed(volume / 1000, 2) + " ml");
    run.figures["labels"].push_back({{"label", label}, {"voxels", count}, {"volume_mm3", volume}});
  }
}

void tellDicom(const fs::path& folder, CommandRun& run) {
  const DicomListing listing = listDicom(folder, run.progress);
  run.figures = {{"kind", "DICOM"}, {"other_files", listing.otherFiles}, {"series", nlohmann::json::array()}};
  for (std::size_t s = 0; s < listing.series.size(); ++s) {
    const DicomSeries& series = listing.series[s];
    const Vector3d spacing = series.spacingMm();
    run.say(describeSeries(series, s + 1));
    run.figures["series"].push_back({{"number", s + 1},
                                     {"code", series.code},
                                     {"modality", series.modality},
                                     {"description", series.description},
                                     {"size", {series.size.x(), series.size.y(), series.size.z()}},
                                     {"spacing_mm", {spacing.x(), spacing.y(), spacing.z()}},
                                     {"files", series.files},
                                     {"readable", series.refusal.empty()}});
    for (const std::string& warning : series.warnings) run.warn(series.code + ": " + warning);
    for (const auto& [label, name] : series.segments)
      run.say("  label " + std::to_string(label) + ": " + name);
  }
  for (const std::string& reason : listing.unreadable) run.warn(reason);
  if (listing.otherFiles > 0)
    run.say(std::to_string(listing.otherFiles) + " files of other kinds passed over");
}

void tellMesh(const fs::path& file, CommandRun& run) {
  const TetrahedralMesh mesh = run.tetrahedra(file);
  const MeshQuality quality = meshQuality(mesh);
  run.say(std::string(mesh.quadratic() ? "quadratic" : "linear") + " tetrahedral mesh of " +
          std::to_string(mesh.size()) + " elements and " + std::to_string(mesh.nodes()) + " nodes in frame " +
          mesh.frame);
  run.say(box(boundingBox(mesh.points)));
  run.say("volume " + fixed(quality.volumeMm3 / 1000, 1) + " ml, mean edge " + fixed(quality.meanEdgeMm, 2) +
          " mm; smallest dihedral angle " + fixed(quality.minDihedralDeg, 1) + " deg, median " +
          fixed(quality.medianDihedralDeg, 1) + " deg; worst scaled Jacobian " +
          fixed(quality.minScaledJacobian, 4));
  run.figures = {{"kind", "tetrahedral mesh"},
                 {"elements", mesh.size()},
                 {"nodes", mesh.nodes()},
                 {"quadratic", mesh.quadratic()},
                 {"frame", mesh.frame},
                 {"volume_mm3", quality.volumeMm3},
                 {"mean_edge_mm", quality.meanEdgeMm},
                 {"min_dihedral_deg", quality.minDihedralDeg},
                 {"median_dihedral_deg", quality.medianDihedralDeg},
                 {"min_radius_ratio", quality.minRadiusRatio},
                 {"min_scaled_jacobian", quality.minScaledJacobian},
                 {"regions", nlohmann::json::array()}};
  std::map<int, std::pair<Index, double>> regions;
  for (Index e = 0; e < mesh.size(); ++e) {
    auto& [count, volume] = regions[mesh.regionOf(e)];
    ++count;
    volume += cornerVolume(mesh, e);
  }
  for (const auto& [region, found] : regions) {
    run.say("region " + std::to_string(region) + ": " + std::to_string(found.first) + " elements, " +
            fixed(found.second / 1000, 2) + " ml");
    run.figures["regions"].push_back(
        {{"number", region}, {"elements", found.first}, {"volume_mm3", found.second}});
  }
}

void tellLandmarks(const fs::path& file, CommandRun& run) {
  const Landmarks landmarks = run.landmarks(file);
  run.say(std::to_string(landmarks.points.size()) + " landmarks in frame " + landmarks.frame);
  run.figures = {{"kind", "landmarks"}, {"count", landmarks.points.size()}, {"frame", landmarks.frame}};
  for (const Landmark& point : landmarks.points)
    run.say("  " + point.name + ": " + fixed(point.position.x(), 2) + " " + fixed(point.position.y(), 2) +
            " " + fixed(point.position.z(), 2) + " mm");
}

void tellTransform(const fs::path& file, CommandRun& run) {
  const Isometry3d transform = run.transform(file);
  const double angle = Eigen::AngleAxisd(transform.linear()).angle() * 180 / EIGEN_PI;
  run.say("rigid transform: rotation " + fixed(angle, 3) + " deg, translation " +
          fixed(transform.translation().norm(), 3) + " mm");
  run.figures = {{"kind", "rigid transform"},
                 {"rotation_deg", angle},
                 {"translation_mm", transform.translation().norm()}};
}

void tellCase(const fs::path& file, CommandRun& run) {
  const CaseDescription description = readCaseDescription(file);
  run.say("case '" + description.name + "'");
  run.figures = {{"kind", "case"}, {"name", description.name}};
  const std::vector<std::pair<const char*, std::string>> parts{
      {"label map", description.labelMap},
      {"pre-op surface", description.preop},
      {"painted surface", description.preopPatches},
      {"scan", description.scan},
      {"pre-op landmarks", description.preopLandmarks},
      {"scan landmarks", description.scanLandmarks},
      {"targets", description.targets},
      {"true targets", description.truthTargets},
      {"registration", description.registration}};
  for (const auto& [what, name] : parts)
    if (!name.empty()) run.say(std::string("  ") + what + ": " + name);
  for (const auto& [name, surface] : description.structures) run.say("  structure " + name + ": " + surface);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const fs::path file = arguments.path("FILE");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) throw InputError("'" + file.string() + "' does not exist; check the path");
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::string extension = fs::path(name).extension().string();
  const bool folder = fs::is_directory(file);
  if (folder && !fs::exists(file / "case.json", ignored) && isDicom(file))
    tellDicom(file, run);
  else if (folder || name == "case.json")
    tellCase(file, run);
  else if (isVolumeFile(file))
    tellVolume(file, run);
  else if (name.ends_with(".mrk.json") || extension == ".fcsv")
    tellLandmarks(file, run);
  else if (extension == ".vtu")
    tellMesh(file, run);
  else if (isSurfaceFile(file))
    tellSurface(file, run);
  else if (extension == ".tfm" || extension == ".txt" || extension == ".json")
    tellTransform(file, run);
  else if (isDicom(file))
    tellDicom(file, run);
  else
    throw InputError("'" + file.string() + "' is of no kind that is known by its ending '" + extension +
                     "'; give a surface, label map, DICOM folder, landmarks, transform or case folder");
}

}  // namespace

Command infoCommand() { return {"info", "File information", "Says what a file is.", declare, execute}; }

}  // namespace falciform::commandline
