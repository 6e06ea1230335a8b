#include "Modules/CommandLine/BuiltInCase.h"

#include <random>

#include "Logic/Acquisition/ScanScene.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::commandline {

namespace {

Landmarks seenByScanner(const Landmarks& landmarks, const VirtualScan& scan) {
  Landmarks seen;
  seen.frame = scan.scan.frame;
  for (const Landmark& point : landmarks.points)
    seen.points.push_back({point.name, scan.scanFromPreop * point.position});
  return seen;
}

/// Fat around the liver, parenchyma, and what is in it, as in a portal-venous phase.
Image evenCt(const LabelMap& labels) {
  Image ct;
  ct.size = labels.size;
  ct.worldFromIndex = labels.worldFromIndex;
  ct.voxels.reserve(labels.voxels.size());
  for (const auto label : labels.voxels)
    ct.voxels.push_back(label == synthetic::kTumour                                           ? 60.F
                        : label == synthetic::kPortalVein || label == synthetic::kHepaticVein ? 190.F
                        : label == synthetic::kLiver                                          ? 110.F
                                                                                              : -90.F);
  return ct;
}

}  // namespace

BuiltInCase makeBuiltInCase(const BuiltInCaseSettings& settings, const Progress& progress) {
  BuiltInCase made;
  made.name =
      settings.packing.packingMm > 0 ? "Built-in liver, packed under its left lobe" : "Built-in liver";
  made.liver = makeSyntheticLiver(settings.liver, progress.part(0.0, 0.5));
  made.labelMap = makeSyntheticLabelMap(settings.liver, progress.part(0.5, 0.8));
  made.ct = evenCt(made.labelMap);
  progress.report(0.8, "Deforming");
  const SyntheticLiver changed = settings.packing.packingMm > 0
                                     ? packLiver(made.liver, settings.packing, progress.part(0.8, 0.9))
                                     : deformSynthetic(made.liver, settings.deformation);
  progress.report(0.9, "Scanning");
  made.scan = scanSurface(changed.surface, centroid(changed.surface.points), settings.scanner,
                          settings.faults, progress.part(0.9, 1.0));
  if (hasRoom(settings.faults)) {
    made.rawScan = made.scan.scan;
    made.scan.scan = organOf(made.rawScan);
  }
  made.truthTargets = seenByScanner(changed.targets, made.scan);
  made.scanLandmarks = seenByScanner(changed.anatomical, made.scan);
  std::mt19937_64 random(static_cast<std::uint64_t>(settings.touch.seed));
  std::normal_distribution<double> normal(0.0, 1.0);
  for (Landmark& point : made.scanLandmarks.points)
    for (int axis = 0; axis < 3; ++axis)
      point.position[axis] += settings.touch.landmarkErrorMm * normal(random);
  return made;
}

}  // namespace falciform::commandline
