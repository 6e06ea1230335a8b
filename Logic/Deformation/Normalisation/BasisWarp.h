#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "Logic/Core/Types.h"
#include "Logic/Deformation/Normalisation/WuFunction.h"

namespace falciform {

/// x -> x + sum_i c_i wu(|x - x_i| / 2 h), centres x_i on a lattice of spacing h: one level of the adaptive
/// bases algorithm (Rohde 2003; thesis eq. IV.1).
class BasisWarp {
 public:
  /// The lattice's first centre and spacing, mm; counts along x, y, z, at least 1. All coefficients zero.
  BasisWarp(const Vector3d& origin, double spacingMm, const Vector3i& counts);

  [[nodiscard]] Index centres() const { return coefficients.rows(); }
  [[nodiscard]] double spacingMm() const { return spacing_; }
  [[nodiscard]] const Vector3i& counts() const { return counts_; }

  [[nodiscard]] Vector3d move(const Vector3d& place) const;
  /// d move / d place.
  [[nodiscard]] Matrix3d gradient(const Vector3d& place) const;
  /// The place that `move` brings here, to 1e-7 mm. Needs compression() < 1.
  [[nodiscard]] Vector3d moveBack(const Vector3d& moved) const;

  /// The strongest compression: minus the least eigenvalue of the symmetric part of d displacement / d place,
  /// over places half a spacing apart. Where it is below 1 everywhere the warp is monotone, so one-to-one
  /// with det J > 0, however much it stretches or turns.
  [[nodiscard]] double compression() const;
  /// Evens out coefficients where that is needed for compression() <= `limit`, and only there.
  void limitCompression(double limit);

  /// Calls `visit(centre, offset)` for each centre whose function is not zero at `place`; offset = (place -
  /// centre) / 2 h.
  template <class Visit>
  void forEachBasis(const Vector3d& place, Visit&& visit) const {
    const Vector3d at = (place - origin_) / spacing_;
    const Vector3i cell = at.array().floor().cast<int>();
    for (int z = std::max(cell.z() - 1, 0); z <= std::min(cell.z() + 2, counts_.z() - 1); ++z)
      for (int y = std::max(cell.y() - 1, 0); y <= std::min(cell.y() + 2, counts_.y() - 1); ++y) {
        const double dy = (at.y() - y) / 2, dz = (at.z() - z) / 2, yz = dy * dy + dz * dz;
        if (yz >= 1) continue;
        for (int x = std::max(cell.x() - 1, 0); x <= std::min(cell.x() + 2, counts_.x() - 1); ++x) {
          const double dx = (at.x() - x) / 2;
          if (dx * dx + yz < 1) visit(centreAt(x, y, z), Vector3d(dx, dy, dz));
        }
      }
  }

  Points coefficients;  ///< one row a centre, x fastest, mm

 private:
  [[nodiscard]] Index centreAt(int x, int y, int z) const {
    return x + static_cast<Index>(counts_.x()) * (y + static_cast<Index>(counts_.y()) * z);
  }
  [[nodiscard]] double cellCompression(const Vector3i& cell, double enough) const;
  [[nodiscard]] bool inside(const Vector3i& centre) const {
    return (centre.array() >= 0).all() && (centre.array() < counts_.array()).all();
  }

  Vector3d origin_;
  double spacing_;
  Vector3i counts_;
};

}  // namespace falciform
