#pragma once
#include "Logic/Acquisition/ScanFaultSettings.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// A laser range scanner: where it stands, what it sees, how it errs.
struct VirtualScannerSettings {
  double azimuthDeg =
      20;  ///< viewpoint: from anterior (0) towards the patient's right (positive), about the body axis
  double elevationDeg = -25;   ///< from horizontal; negative looks up from the feet
  double distanceMm = 450;     ///< from the surface's centroid
  double fieldOfViewDeg = 35;  ///< of the longer side of the raster
  int lines = 500;             ///< at most 500
  int samples = 512;           ///< per line, at most 512
  int stride = 2;              ///< keep every n-th line and sample
  double noiseMm = 0.5;        ///< standard deviation along the ray
  double windowShare = 0.9;    ///< central share of the raster that is kept, each way: partial coverage
  double grazingDeg = 80;      ///< rays that meet the surface flatter than this against its normal are lost
  int seed = 1;
};

template <class Visitor>
void describe(VirtualScannerSettings& s, Visitor&& field) {
  field(FieldInfo{"azimuthDeg", "Azimuth", "deg", -180, 180,
                  "Viewpoint from the front (0) towards the patient's right."},
        s.azimuthDeg);
  field(FieldInfo{"elevationDeg", "Elevation", "deg", -89, 89,
                  "Viewpoint above (+) or below (-) the horizontal."},
        s.elevationDeg);
  field(FieldInfo{"distanceMm", "Distance", "mm", 100, 2000, "From the surface's centroid."}, s.distanceMm);
  field(FieldInfo{"fieldOfViewDeg", "Field of view", "deg", 5, 90, "Angle of the raster's longer side."},
        s.fieldOfViewDeg);
  field(FieldInfo{"lines", "Lines", "", 2, 500, "Raster lines."}, s.lines);
  field(FieldInfo{"samples", "Samples", "", 2, 512, "Samples a line."}, s.samples);
  field(FieldInfo{"stride", "Stride", "", 1, 16, "Keep every n-th line and sample."}, s.stride);
  field(FieldInfo{"noiseMm", "Noise", "mm", 0, 20, "Standard deviation along the ray."}, s.noiseMm);
  field(
      FieldInfo{"windowShare", "Window", "", 0.05, 1, "Central share of the raster that is kept, each way."},
      s.windowShare);
  field(FieldInfo{"grazingDeg", "Grazing limit", "deg", 30, 90,
                  "Rays flatter than this to the surface are lost."},
        s.grazingDeg);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647, "Draws the noise and the scanner's frame."}, s.seed);
}

struct VirtualScan {
  Surface
      scan;  ///< in the scanner's own frame ("scanner"), triangulated raster, patches carried over, colours
  Isometry3d scanFromPreop;  ///< the truth: maps the surface's frame to the scanner's
  double coverage = 0;       ///< share of the surface's area that was seen
};

/// Casts the raster's rays at the surface and keeps the first hits. The scanner's frame is turned and moved
/// at random by the seed. Throws InputError if nothing is seen.
[[nodiscard]] VirtualScan scanSurface(const Surface& surface, const VirtualScannerSettings& settings,
                                      const Progress& progress = {});
/// The same with the scanner aimed at `lookAt` (mm, in the surface's frame) instead of at the centroid, in an
/// operating room: shadows, lost rays, smoke, instruments and cloth. What each point came from stands in the
/// array "structure" (ScanScene.h) where there is more than the organ; coverage and patches are the organ's
/// alone. Smoke keeps its stray points, which a clean scan leaves out.
[[nodiscard]] VirtualScan scanSurface(const Surface& surface, const Vector3d& lookAt,
                                      const VirtualScannerSettings& settings, const ScanFaultSettings& faults,
                                      const Progress& progress = {});

/// The noise of the thesis's scanner (RealScan 200C): 0.3 mm at 300 mm, 1.0 mm at 800 mm, linear between and
/// on. The maker calls it "average deviation from planarity"; it is taken as standard deviation.
[[nodiscard]] double rangeNoiseMm(double distanceMm);

/// Unit vector from what the scanner looks at towards where it stands, in the surface's frame.
[[nodiscard]] Vector3d towardsScanner(const VirtualScannerSettings& settings);

}  // namespace falciform
