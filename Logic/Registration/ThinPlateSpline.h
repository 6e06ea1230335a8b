#pragma once
#include "Logic/Core/Types.h"

namespace falciform {

/// A smooth warp of space: a rigid motion and a thin-plate bend, y(x) = T x - sum_k w_k |x - x_k| with
/// sum_k w_k = 0 (Bookstein 1989, in three dimensions). There is no affine part: a scan of a third of an
/// organ says nothing of shear at its far side. Near the knots the bend can be as good as affine; far away it
/// tends to a bounded shift.
class ThinPlateSpline {
 public:
  ThinPlateSpline() = default;
  ThinPlateSpline(const Isometry3d& rigid, Points knots, Points weights)
      : rigid_(rigid), knots_(std::move(knots)), weights_(std::move(weights)) {}

  /// N x 3 points moved.
  [[nodiscard]] Points operator()(const Points& points) const;
  [[nodiscard]] const Isometry3d& rigid() const { return rigid_; }

 private:
  Isometry3d rigid_ = Isometry3d::Identity();
  Points knots_ = Points(0, 3), weights_ = Points(0, 3);
};

/// Fits splines to one set of source points, made ready once for any number of targets.
class ThinPlateFit {
 public:
  /// `source`: N x 3 mm; `knots`: K x 3, where the bend may act, K > 1 for a bend at all.
  ThinPlateFit(const Points& source, const Points& knots);

  /// Minimises sum_i v_i |y(x_i) - target_i|^2 / sum v + stiffness E(y), in two steps: the rigid part alone,
  /// then the bend and a shift. E = sum_jk w_j w_k -|x_j - x_k| with lengths in units of the knots' RMS
  /// radius, so that `stiffness` > 0 is a pure number; infinite: no bend. `weights`: N values >= 0, some of
  /// them > 0.
  [[nodiscard]] ThinPlateSpline fit(const Points& target, const VectorXd& weights, double stiffness) const;

 private:
  Points source_, knots_;
  double unit_ = 1;         // RMS radius of the knots, mm
  Eigen::MatrixXd free_;    // K x (K-1): weights that sum to 0
  Eigen::MatrixXd bend_;    // N x K: displacement of the source points by each of them, and by a shift
  Eigen::MatrixXd energy_;  // K x K; 0 for the shift
};

}  // namespace falciform
