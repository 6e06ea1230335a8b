#include "Logic/Acquisition/Phantom.h"

#include <algorithm>

#include "Logic/Acquisition/LiverStructures.h"
#include "Logic/Acquisition/PhantomBeads.h"
#include "Logic/Acquisition/PhantomBody.h"
#include "Logic/Acquisition/PhantomCt.h"
#include "Logic/Acquisition/PhantomPainting.h"
#include "Logic/Acquisition/RegionCentroid.h"
#include "Logic/Acquisition/ScanScene.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Geometry/SphereFit.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {
namespace {

constexpr char kScanFrame[] = "scanner";

Landmarks spheresOf(const PhantomBody& body) {
  Landmarks spheres;
  for (std::size_t s = 0; s < body.spheres.size(); ++s)
    spheres.points.push_back({"sphere " + std::to_string(s + 1), body.spheres[s]});
  return spheres;
}

Landmarks moved(Landmarks landmarks, const Isometry3d& scanFromPreop) {
  landmarks.frame = kScanFrame;
  for (Landmark& point : landmarks.points) point.position = scanFromPreop * point.position;
  return landmarks;
}

/// Each landmark through `locate`, which is given a place near it as a user would click it: on the sphere, so
/// never farther off than `longestMm`.
template <class Locate>
Landmarks located(const Landmarks& truth, double clickErrorMm, double longestMm, Draws draws,
                  const Locate& locate) {
  Landmarks found = truth;
  for (Landmark& point : found.points) {
    const Vector3d off = clickErrorMm * draws.normal3();
    const Vector3d click = point.position + off * std::min(1.0, longestMm / std::max(off.norm(), 1e-9));
    try {
      point.position = locate(click);
    } catch (const InputError& error) {
      throw InputError(point.name + ": " + error.what());
    }
  }
  return found;
}

/// The liver's points of the whole view, and the patches drawn on them.
Surface liverOf(const Surface& wholeView, const LiverShape& liver, const Isometry3d& preopFromScan) {
  Surface scan = organOf(wholeView);
  scan.patchNames.clear();
  scan.patch = paintPhantomScan(liver, transformed(scan.points, preopFromScan));
  return scan;
}

}  // namespace

PhantomPlan thesisPhantom() {
  PhantomPlan plan;
  plan.liver.edgeLengthMm = 1.0;
  plan.liver.voxelMm = 1.09;
  plan.scanner.stride = 1;
  plan.scanner.windowShare = 1;
  plan.scanner.azimuthDeg = 15;
  plan.scanner.elevationDeg = 10;
  plan.scanner.distanceMm = 450;
  plan.scanner.fieldOfViewDeg = 51.7;
  plan.scanner.noiseMm = rangeNoiseMm(plan.scanner.distanceMm);
  return plan;
}

Vector3d locateSphere(const Points& scan, const Vector3d& click, double radiusMm) {
  constexpr double kAround = 10;  // mm: three times a click's error
  constexpr std::size_t kFewest = 30;
  std::vector<int> near;
  for (Index i = 0; i < scan.rows(); ++i)
    if ((scan.row(i).transpose() - click).norm() < radiusMm + kAround) near.push_back(static_cast<int>(i));
  if (near.size() < kFewest)
    throw InputError("the scan has " + std::to_string(near.size()) +
                     " points there; widen the field of view or move the scanner");
  return fitSphereRobust(rowsOf(scan, near), radiusMm).centre;
}

Landmarks locateBeads(const Image& ct) {
  constexpr double kLargestMm3 = 30;  // three voxels across at 1 mm: a bead and its blur
  Landmarks beads;
  for (const GrownRegion& body : findBodies(ct, phantom::kBeadLevel, 0, kLargestMm3))
    beads.points.push_back({"bead " + std::to_string(beads.points.size() + 1), body.centre});
  return beads;
}

PhantomCase makePhantomCase(const PhantomPlan& plan, const Progress& progress) {
  checkSettings(plan.liver);
  checkSettings(plan.scanner);
  checkSettings(plan.faults);
  checkSettings(plan.phantom);
  const double radius = plan.phantom.sphereRadiusMm, click = plan.phantom.clickErrorMm,
               onSphere = 0.6 * radius;
  const auto seed = static_cast<std::uint64_t>(plan.phantom.seed);
  const LiverShape liver(plan.liver);
  // Region growing sums two layers of voxels around a sphere and looks at a third: the liver stays beyond.
  const double gap = std::max(plan.phantom.sphereGapMm, 4 * plan.liver.voxelMm);
  PhantomBody body = placeSpheres(liver, radius, gap, plan.scanner);
  PhantomCase made;
  made.trueSpheresCt = spheresOf(body);
  made.targets = insideTargets(liver, placeStructures(liver));
  if (plan.phantom.beads > 0) {
    made.targets = placeBeads(liver, {.count = plan.phantom.beads, .seed = seed});
    for (const Landmark& bead : made.targets.points) body.beads.push_back(bead.position);
  }

  made.ct = imagePhantom(body, plan.liver.voxelMm, plan.phantom.ctNoiseHu, plan.phantom.seed,
                         progress.part(0, 0.4));
  made.ctSurface = siliconeSurface(made.ct);
  const double ballMm3 = 4.2 * radius * radius * radius;
  made.spheresCt = located(made.trueSpheresCt, click, onSphere, Draws(seed, 10), [&](const Vector3d& near) {
    return growRegion(made.ct, near, phantom::kTeflonLevel, 2 * ballMm3).centre;
  });
  if (plan.phantom.beads > 0) made.beadsCt = locateBeads(made.ct);
  made.labels = labelPhantom(made.ct, body.spheres, radius);

  const Surface mesh = meshPhantom(body, plan.liver.edgeLengthMm, progress.part(0.45, 0.8));
  VirtualScan seen = scanSurface(mesh, middleOf(liver), plan.scanner, plan.faults, progress.part(0.8, 1));
  made.scanFromPreop = seen.scanFromPreop;
  made.wholeView = std::move(seen.scan);
  made.scan = liverOf(made.wholeView, liver, made.scanFromPreop.inverse());
  made.subRegion = subset(
      made.scan, surgicalSubRegion(liver, transformed(made.scan.points, made.scanFromPreop.inverse())));
  made.trueSpheresScan = moved(made.trueSpheresCt, made.scanFromPreop);
  made.trueTargets = moved(made.targets, made.scanFromPreop);
  made.spheresScan =
      located(made.trueSpheresScan, click, onSphere, Draws(seed, 11),
              [&](const Vector3d& near) { return locateSphere(made.wholeView.points, near, radius); });
  progress.report(1);
  return made;
}

}  // namespace falciform
