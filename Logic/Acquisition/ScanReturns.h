#pragma once
#include <vector>

#include "Logic/Acquisition/ScanScene.h"
#include "Logic/Core/Progress.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

/// What one ray of the raster found: nothing if triangle is -1.
struct ScanReturn {
  int triangle = -1;
  int structure = structure::kOrgan;
  double range = 0;    ///< mm from the camera, without noise
  double areaMm2 = 0;  ///< of the surface that this ray stands for; 0 for smoke
  Vector3d place = Vector3d::Zero(), direction = Vector3d::Zero();
};

/// First hits of the view's rays, rows x columns, columns fastest. Lost are rays that meet a back face or one
/// flatter than `grazingDeg`, that the laser does not reach, or that drop out; smoke stands before what it
/// hides. Deterministic by the faults' seed, whatever the number of threads.
[[nodiscard]] std::vector<ScanReturn> castScan(const ScanScene& scene, const TriangleTree& tree,
                                               const ScannerView& view, double grazingDeg,
                                               const ScanFaultSettings& faults, const Progress& progress);

/// The scene's vertex nearest to a return, of its triangle's three.
[[nodiscard]] int nearestCorner(const Surface& surface, int triangle, const Vector3d& place);

}  // namespace falciform
