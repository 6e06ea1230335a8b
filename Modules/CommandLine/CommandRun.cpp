#include "Modules/CommandLine/CommandRun.h"

#include <algorithm>
#include <iostream>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/MeshFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

void CommandRun::warn(const std::string& warning) {
  auto& known = provenance.warnings;
  if (std::find(known.begin(), known.end(), warning) != known.end()) return;
  known.push_back(warning);
}

void CommandRun::warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) warn(warning);
}

void CommandRun::print() const {
  for (const std::string& warning : provenance.warnings) std::cerr << "warning: " << warning << '\n';
  if (quiet) return;
  for (const std::string& line : lines_) std::cout << line << '\n';
}

void CommandRun::remember(const fs::path& file) {
  // The name alone: folders may name a patient.
  std::pair<std::string, std::string> entry{file.filename().string(), sha256OfFile(file)};
  auto& known = provenance.inputSha256;
  if (std::find(known.begin(), known.end(), entry) == known.end()) known.push_back(std::move(entry));
}

void CommandRun::warnOf(const std::string& name, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    warn(warning.find(name) == std::string::npos ? name + ": " + warning : warning);
}

template <class T>
T CommandRun::keep(Loaded<T> loaded, const fs::path& file) {
  remember(file);
  warnOf(file.filename().string(), loaded.warnings);
  return std::move(loaded.value);
}

template <class T>
T CommandRun::keepVolume(Loaded<T> loaded, const fs::path& file, const std::string& series) {
  if (isVolumeFile(file)) return keep(std::move(loaded), file);
  const DicomListing listing = listDicom(file);
  for (const DicomSeries& one : listing.series) {
    if (!series.empty() && &one != &chooseSeries(listing, series)) continue;
    provenance.inputSha256.emplace_back("DICOM series " + one.code, sha256OfSeries(one));
  }
  warnOf("DICOM", listing.unreadable);
  warnOf("DICOM", loaded.warnings);
  return std::move(loaded.value);
}

TetrahedralMesh CommandRun::tetrahedra(const fs::path& file) { return keep(readMesh(file), file); }

Surface CommandRun::surface(const fs::path& file) { return keep(readSurface(file), file); }
Surface CommandRun::mesh(const fs::path& file) {
  Surface read = surface(file);
  if (const Index edges = inspectTopology(read).nonManifoldEdges; edges > 0)
    throw InputError("'" + file.string() + "' is not a manifold surface: " + std::to_string(edges) +
                     " edges have three or more triangles; repair it or import it anew from its label map");
  return read;
}
LabelMap CommandRun::labelMap(const fs::path& file, const std::string& series) {
  return keepVolume(readLabelMap(file, series), file, series);
}
NamedLabels CommandRun::namedLabels(const fs::path& file, const std::string& series) {
  return keepVolume(readNamedLabels(file, series), file, series);
}
Image CommandRun::image(const fs::path& file, const std::string& series) {
  return keepVolume(readImage(file, series), file, series);
}
Landmarks CommandRun::landmarks(const fs::path& file) { return keep(readLandmarks(file), file); }
Isometry3d CommandRun::transform(const fs::path& file) {
  return keep(Loaded<Isometry3d>{readTransform(file), {}}, file);
}

nlohmann::json CommandRun::sidecar() const {
  nlohmann::json json = toJson(provenance);
  json["settings"] = settings;
  json["frames"] = frames;
  json["units"] = "mm unless the key says otherwise (_mm, _mm2, _mm3, _deg, _s)";
  json["figures"] = figures;
  return json;
}

void CommandRun::writeSidecar(const fs::path& file) {
  writeTextFile(outputs.staged(file), Overwrite::Replace, sidecar().dump(2) + "\n");
}

fs::path sidecarOf(const fs::path& file) { return file.string() + ".json"; }

}  // namespace falciform::commandline
