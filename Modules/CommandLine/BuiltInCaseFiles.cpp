#include <algorithm>
#include <cctype>

#include "Logic/Acquisition/ScanScene.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/CommandLine/BuiltInCase.h"

namespace falciform::commandline {

namespace {

constexpr char kRawScan[] = "scan_raw.vtp";

/// Names of the structures are known before they are made.
const std::vector<std::string> kStructures{"hepatic vein", "portal vein", "tumour 1", "tumour 2"};

std::string structureFile(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return "structures/" + name + ".vtp";
}

CaseDescription describeBuiltInCase(const BuiltInCase& made, const std::filesystem::path& folder) {
  CaseDescription description;
  description.folder = folder;
  description.name = made.name;
  description.labelMap = "labelmap.nii.gz";
  description.ct = "ct.nii.gz";
  description.labels = {synthetic::kLiver, synthetic::kTumour, synthetic::kPortalVein,
                        synthetic::kHepaticVein};
  description.preopPatches = "preop_painted.vtp";
  description.scan = "scan.vtp";
  description.preopLandmarks = "preop_landmarks.mrk.json";
  description.scanLandmarks = "scan_landmarks.mrk.json";
  description.targets = "targets.mrk.json";
  description.truthTargets = "truth_targets.mrk.json";
  for (const auto& [name, surface] : made.liver.structures)
    description.structures.emplace_back(name, structureFile(name));
  description.settings = {{"import", {{"edgeLengthMm", 2.0}}}};
  return description;
}

}  // namespace

std::vector<std::filesystem::path> builtInCaseFiles(const std::filesystem::path& folder,
                                                    const ScanFaultSettings& faults) {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"case.json", "ct.nii.gz", "labelmap.nii.gz", "preop_painted.vtp", "scan.vtp",
                           "preop_landmarks.mrk.json", "scan_landmarks.mrk.json", "targets.mrk.json",
                           "truth_targets.mrk.json", "truth_scan_from_preop.tfm"})
    files.push_back(folder / name);
  if (hasRoom(faults)) files.push_back(folder / kRawScan);
  if (faults.photograph) {
    for (const auto& beside : filesBeside(folder / "scan.vtp")) files.push_back(beside);
    if (hasRoom(faults))
      for (const auto& beside : filesBeside(folder / kRawScan)) files.push_back(beside);
  }
  for (const std::string& name : kStructures) files.push_back(folder / structureFile(name));
  return files;
}

void writeBuiltInCase(const BuiltInCase& made, const std::filesystem::path& folder, const Outputs& outputs) {
  const auto at = [&](const std::string& name) { return outputs.staged(folder / name); };
  constexpr auto replace = Overwrite::Replace;  // the hidden folder is ours
  writeImage(at("ct.nii.gz"), made.ct, replace);
  writeLabelMap(at("labelmap.nii.gz"), made.labelMap, replace);
  writeSurface(at("preop_painted.vtp"), made.liver.surface, replace);
  writeSurface(at("scan.vtp"), made.scan.scan, replace);
  if (made.rawScan.size() > 0) writeSurface(at(kRawScan), made.rawScan, replace);
  writeLandmarks(at("preop_landmarks.mrk.json"), made.liver.anatomical, replace);
  writeLandmarks(at("scan_landmarks.mrk.json"), made.scanLandmarks, replace);
  writeLandmarks(at("targets.mrk.json"), made.liver.targets, replace);
  writeLandmarks(at("truth_targets.mrk.json"), made.truthTargets, replace);
  writeTransform(at("truth_scan_from_preop.tfm"), made.scan.scanFromPreop,
                 "the truth: maps pre-op LPS mm to scan mm, without the deformation", replace);
  for (const auto& [name, surface] : made.liver.structures)
    writeSurface(at(structureFile(name)), surface, replace);
  // The description names files of its own folder, so it is written from the hidden one.
  CaseDescription description = describeBuiltInCase(made, at("case.json").parent_path());
  writeCaseDescription(description, replace);
}

}  // namespace falciform::commandline
