#pragma once
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// A voxel map that holds at each node the closest point of a target, and gives closest points anywhere by
/// interpolation (closest-point transform: Kapoutsis 1998, Ge 1996, Cao 2004). Built by exact search, where
/// the papers propagate. Immutable; any number of threads may ask.
class ClosestPointTransform {
 public:
  /// Nodes `voxelMm` apart over the target's box and `marginMm` around it; farther apart if there would be
  /// more than two million. Both > 0.
  ClosestPointTransform(const LabelledTarget& target, double voxelMm, double marginMm);

  /// The trilinear mean of the closest points at the eight nodes around; where they lie far apart (the query
  /// is near the target's medial axis, and their mean near nothing), the one of them that is nearest. Outside
  /// the map: as at the nearest place of the map.
  [[nodiscard]] Vector3d closest(const Vector3d& query) const;
  [[nodiscard]] double voxelMm() const { return voxel_; }

 private:
  [[nodiscard]] Index node(const Vector3i& at) const {
    return at.x() + count_.x() * (at.y() + static_cast<Index>(count_.y()) * at.z());
  }

  Vector3d origin_;
  Vector3i count_;
  double voxel_;
  Points closest_;  // one row a node, x fastest
};

/// ICP whose closest points come from a closest-point transform of the pre-op points. As runPatchIcp with
/// method Icp else; patches are not looked at.
[[nodiscard]] PatchIcpResult registerClosestPointTransform(const PreparedPreop& preop, const Surface& scan,
                                                           const RegistrationSettings& settings,
                                                           const Isometry3d& preopFromScanStart,
                                                           const Progress& progress = {},
                                                           const IterationObserver& observer = {});

}  // namespace falciform
