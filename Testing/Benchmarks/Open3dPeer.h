#pragma once
#include <memory>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// Open3D's global registration as its tutorial has it (Global registration, 0.16), with the lengths in mm of
/// the voxel size v: voxel downsampling; normals from 2 v, 30 neighbours; FPFH from 5 v, 100 neighbours;
/// RANSAC with mutual filter, 3 points, edge length 0.9, distance 1.5 v, 100,000 iterations, confidence
/// 0.999, or FGR at 0.5 v; then point-to-plane ICP on all points. The tutorial's ICP reaches 0.4 v; here it
/// is 7.5 mm, with which Open3D succeeds more often on livers that bend and no less on those that do not.
class Open3dTarget {
 public:
  /// Voxel filter, normals, features and trees of the pre-op side.
  explicit Open3dTarget(const Surface& preop, double voxelMm = 5);
  ~Open3dTarget();

  /// Returns preopFromScan. `scan.normals` say to which side its own estimates look. The seed is RANSAC's.
  [[nodiscard]] Isometry3d ransac(const Surface& scan, int seed) const;
  [[nodiscard]] Isometry3d fgr(const Surface& scan) const;
  /// Point-to-plane ICP alone, `iterations` of them, all points, correspondences up to `reachMm`.
  [[nodiscard]] Isometry3d icp(const Surface& scan, const Isometry3d& preopFromScan, int iterations,
                               double reachMm) const;

 private:
  struct Clouds;
  double voxelMm_;
  std::unique_ptr<const Clouds> clouds_;
};

}  // namespace falciform::bench
