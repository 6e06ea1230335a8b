#pragma once
#include <vector>

#include "Logic/Acquisition/ImplicitSurface.h"
#include "Logic/Acquisition/LiverShape.h"
#include "Logic/Acquisition/VirtualScanner.h"

namespace falciform {

/// A silicone liver with Teflon spheres around it (thesis Fig. III.5), LPS mm. What carries the spheres is
/// left out: foam, which neither CT nor scanner shows once the scan is cut to the phantom.
struct PhantomBody {
  LiverShape liver;
  std::vector<Vector3d> spheres;  ///< centres
  double sphereRadiusMm = 0;
  std::vector<Vector3d> beads;  ///< of steel, 1 mm across, in the silicone (thesis ch. V); CT alone sees them

  /// Corners of a box that holds all of it with some air, rows 0 and 1.
  [[nodiscard]] Box bounds() const;
};

inline constexpr double kBeadRadiusMm = 0.5;

/// What the scanner is aimed at: the middle of the liver's box.
[[nodiscard]] Vector3d middleOf(const LiverShape& liver);

/// The liver with seven spheres around it, as the scanner sees it: none hides or touches the liver or
/// another, at seven uneven angles and depths, so that no other order of them fits. `gapMm` > 0: of air
/// between a sphere's outline and the liver's in the scanner's picture.
[[nodiscard]] PhantomBody placeSpheres(const LiverShape& liver, double sphereRadiusMm, double gapMm,
                                       const VirtualScannerSettings& scanner);

/// What the scanner's rays may hit: the liver with edges of `edgeLengthMm`, label 0, and the spheres, finer,
/// labelled patch::kFirstNamed and up, named "sphere 1" and up. The array "structure" (ScanScene.h) says
/// which is which.
[[nodiscard]] Surface meshPhantom(const PhantomBody& body, double edgeLengthMm,
                                  const Progress& progress = {});

}  // namespace falciform
