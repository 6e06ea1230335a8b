#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Volume.h"

namespace falciform {

struct FrontPlan {
  double curvature = 0.3;  ///< weight of the mean curvature, voxels: bends sharper than this get no way
  double patienceMm = 2;   ///< way that a slowed front has lost when its speed has fallen to 1/e
};

/// A closed front as the zero level of a function kept near it only (Sethian), with a speed that remembers.
/// The front moves along its normal by F = A (s - b kappa) (Eq. II.1), where s in [-1, 1] is what the
/// image says, kappa the curvature, and A = exp(-M / patience) the accumulated part (Dawant): each place on
/// the front carries a memory M of the way that it has lost by being slower than it could have been, and
/// hands it on to the voxels it enters. So a front that has been slowed for long, at a weak edge, does not
/// gain speed again behind it: it stops.
class LevelSetFront {
 public:
  /// From a function that is negative inside, mm; it need be a distance near its zero level only.
  LevelSetFront(Image phi, const FrontPlan& plan);

  /// One time step; `speed` holds s. Returns the mean of |F| along the front, 1 at full speed.
  double advance(const Image& speed);

  [[nodiscard]] const Image& phi() const { return phi_; }

 private:
  void rebuildBand();
  void restoreDistance();
  void repeatBorder();
  [[nodiscard]] float at(std::size_t voxel, int axis, int side) const;

  FrontPlan plan_;
  Image phi_, memory_;
  std::vector<std::size_t> band_;
  std::vector<float> next_;
  double step_ = 0, width_ = 0;
  Vector3d inverse_ = Vector3d::Ones();  // 1 / spacing
  std::ptrdiff_t stride_[3]{};
};

/// Signed distance to the border of the flagged voxels, mm, negative inside, zero half-way between centres.
[[nodiscard]] Image signedDistance(const Volume<std::uint8_t>& flags);

}  // namespace falciform
