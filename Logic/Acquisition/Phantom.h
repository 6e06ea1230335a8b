#pragma once
#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"

namespace falciform {

/// The spheres of the phantom, its CT and how its spheres are pointed at.
struct PhantomSettings {
  double sphereRadiusMm = 12.7;  ///< one inch across; the thesis does not say
  double sphereGapMm = 8;  ///< air between liver and spheres, as the scanner sees them; at least 4 voxels
  double ctNoiseHu = 15;
  int beads = 0;            ///< steel beads of 1 mm in the silicone, as thesis ch. V has 43; targets then
  double clickErrorMm = 3;  ///< SD per axis with which the user points at a sphere before it is located
  int seed = 1;
};

template <class Visitor>
void describe(PhantomSettings& s, Visitor&& field) {
  field(FieldInfo{"sphereRadiusMm", "Sphere radius", "mm", 5, 30, "Of the phantom's seven spheres."},
        s.sphereRadiusMm);
  field(
      FieldInfo{
          "sphereGapMm", "Sphere gap", "mm", 6, 60,
          "Air between the phantom's spheres and its liver, as the scanner sees them; at least 4 voxels."},
      s.sphereGapMm);
  field(FieldInfo{"ctNoiseHu", "CT noise", "HU", 0, 200, "Standard deviation of the phantom's CT."},
        s.ctNoiseHu);
  field(FieldInfo{"beads", "Beads", "", 0, 200,
                  "Steel beads of 1 mm in the silicone; they are the targets then. The thesis's has 43."},
        s.beads);
  field(FieldInfo{"clickErrorMm", "Click error", "mm", 0, 4,
                  "Standard deviation per axis with which spheres are pointed at."},
        s.clickErrorMm);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647, "Draws CT noise and clicks."}, s.seed);
}

/// All that a phantom is made from.
struct PhantomPlan {
  SyntheticLiverSettings liver;    ///< edgeLengthMm: of the mesh that is scanned; voxelMm: of the CT
  VirtualScannerSettings scanner;  ///< of both scans
  ScanFaultSettings faults;        ///< of the room in which it is scanned
  PhantomSettings phantom;
};
/// The plan whose counts are the thesis's within 10 %: CT 106,661 points, scans 34,546 and 12,376.
[[nodiscard]] PhantomPlan thesisPhantom();

/// The phantom of thesis ch. III as imaged by CT and scanner, with the truth beside it. Not yet registered:
/// its CT surface has no patches, since the thesis carries them over by the gold standard.
struct PhantomCase {
  Image ct;                          ///< LPS
  LabelMap labels;                   ///< by threshold, values of `phantom` (PhantomCt.h)
  Surface ctSurface;                 ///< silicone, LPS mm
  Surface wholeView;                 ///< all that the scanner saw, scanner mm; spheres are named patches
  Surface scan;                      ///< the liver alone, patches 1 and 2 as a user would mark them
  Surface subRegion;                 ///< the part of `scan` that is open to view in surgery
  Landmarks spheresCt, spheresScan;  ///< as located: region growing; least squares (Ahn 2001)
  Landmarks trueSpheresCt, trueSpheresScan;  ///< where they are
  Landmarks beadsCt;                         ///< as found in the CT, in no given order; none without beads
  /// Inside the liver, the beads' true places if there are any: LPS mm, and scanner mm.
  Landmarks targets, trueTargets;
  Isometry3d scanFromPreop;  ///< the truth
};

/// Builds, images, scans and locates. Deterministic by the plan. Throws InputError if a sphere is not in the
/// scanner's view.
[[nodiscard]] PhantomCase makePhantomCase(const PhantomPlan& plan, const Progress& progress = {});

/// The steel beads of a phantom's CT, found without clicks: bodies above phantom::kBeadLevel of at most 30
/// mm3.
[[nodiscard]] Landmarks locateBeads(const Image& ct);

/// The sphere of known radius near `click` (mm) in a scan: robust least squares on the points within
/// `radiusMm` + 10 mm of it. Throws InputError if fewer than 30 points lie there.
[[nodiscard]] Vector3d locateSphere(const Points& scan, const Vector3d& click, double radiusMm);

}  // namespace falciform
