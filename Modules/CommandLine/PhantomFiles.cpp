#include "Logic/Acquisition/PhantomCt.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/CommandLine/PhantomExperiment.h"

namespace falciform::commandline {

namespace {

CaseDescription describePhantom(const std::filesystem::path& folder) {
  CaseDescription description;
  description.folder = folder;
  description.name = "Silicone liver phantom";
  description.labelMap = "labelmap.nii.gz";
  description.labels = {phantom::kSiliconeLabel};
  description.preop = "preop.vtp";
  description.scan = "scan.vtp";
  description.preopLandmarks = "spheres_ct.mrk.json";
  description.scanLandmarks = "spheres_scan.mrk.json";
  description.targets = "targets.mrk.json";
  description.truthTargets = "truth_targets.mrk.json";
  return description;
}

}  // namespace

std::vector<std::filesystem::path> phantomFiles(const std::filesystem::path& folder,
                                                const PhantomPlan& plan) {
  std::vector<std::filesystem::path> files;
  for (const char* name :
       {"case.json", "ct.nii.gz", "labelmap.nii.gz", "preop.vtp", "scan.vtp", "scan_subregion.vtp",
        "scan_whole_view.vtp", "spheres_ct.mrk.json", "spheres_scan.mrk.json", "truth_spheres_ct.mrk.json",
        "truth_spheres_scan.mrk.json", "targets.mrk.json", "truth_targets.mrk.json",
        "gold_scan_from_preop.tfm", "truth_scan_from_preop.tfm"})
    files.push_back(folder / name);
  if (plan.phantom.beads > 0) files.push_back(folder / "beads_ct.mrk.json");
  if (plan.faults.photograph)
    for (const char* scan : {"scan.vtp", "scan_subregion.vtp", "scan_whole_view.vtp"})
      for (const auto& beside : filesBeside(folder / scan)) files.push_back(beside);
  return files;
}

void writePhantom(const PhantomExperiment& experiment, const std::filesystem::path& folder,
                  const Outputs& outputs) {
  const auto at = [&](const char* name) { return outputs.staged(folder / name); };
  constexpr auto replace = Overwrite::Replace;  // the hidden folder is ours
  const PhantomCase& made = experiment.made;
  writeImage(at("ct.nii.gz"), made.ct, replace);
  writeLabelMap(at("labelmap.nii.gz"), made.labels, replace);
  writeSurface(at("preop.vtp"), experiment.preop, replace);
  writeSurface(at("scan.vtp"), made.scan, replace);
  writeSurface(at("scan_subregion.vtp"), made.subRegion, replace);
  writeSurface(at("scan_whole_view.vtp"), made.wholeView, replace);
  writeLandmarks(at("spheres_ct.mrk.json"), made.spheresCt, replace);
  writeLandmarks(at("spheres_scan.mrk.json"), made.spheresScan, replace);
  writeLandmarks(at("truth_spheres_ct.mrk.json"), made.trueSpheresCt, replace);
  writeLandmarks(at("truth_spheres_scan.mrk.json"), made.trueSpheresScan, replace);
  if (experiment.plan.phantom.beads > 0) writeLandmarks(at("beads_ct.mrk.json"), made.beadsCt, replace);
  writeLandmarks(at("targets.mrk.json"), made.targets, replace);
  writeLandmarks(at("truth_targets.mrk.json"), made.trueTargets, replace);
  writeTransform(at("gold_scan_from_preop.tfm"), experiment.gold.targetFromSource,
                 "the gold standard, from the spheres: maps pre-op LPS mm to scan mm", replace);
  writeTransform(at("truth_scan_from_preop.tfm"), made.scanFromPreop,
                 "the truth: maps pre-op LPS mm to scan mm", replace);
  // The description names files of its own folder, so it is written from the hidden one.
  CaseDescription description = describePhantom(at("case.json").parent_path());
  writeCaseDescription(description, replace);
}

}  // namespace falciform::commandline
