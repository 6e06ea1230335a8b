#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "Logic/Core/Types.h"
#include "Logic/Deformation/Normalisation/BasisWarp.h"

namespace falciform {

/// A smooth one-to-one map of space that carries one patient's liver onto another's: an affine map, then a
/// chain of warps in the source's frame. Each is one-to-one by a bound on its coefficients, so the whole has
/// det J > 0 everywhere (thesis ch. IV, "Inter-Patient Deformable Registration"; METHODS 3.3).
struct LiverMap {
  Eigen::Affine3d sourceFromTarget = Eigen::Affine3d::Identity();  ///< first
  std::vector<BasisWarp> warps;                                    ///< then these, in order

  /// Where in the source patient places of the target patient lie, mm.
  [[nodiscard]] Points toSource(const Points& target) const;
  /// The inverse, to 1e-6 mm.
  [[nodiscard]] Points toTarget(const Points& source) const;
  /// det of d toSource / d target at each place: above 1 where the source is larger there.
  [[nodiscard]] VectorXd determinants(const Points& target) const;
};

}  // namespace falciform
