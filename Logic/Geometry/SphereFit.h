#pragma once
#include <optional>

#include "Logic/Core/Types.h"

namespace falciform {

/// A sphere through scattered points. Numerical failure is `converged = false`, with the best that was found.
struct SphereFit {
  Vector3d centre = Vector3d::Zero();  ///< mm, in the points' frame
  double radiusMm = 0;
  double rmsMm = 0;          ///< of the orthogonal distances of the points used
  double centreErrorMm = 0;  ///< expected length of the centre's error: root of the trace of its covariance
  Index used = 0;            ///< points that are no outliers
  int iterations = 0;
  bool converged = false;
};

/// The sphere that minimises sum_i (|p_i - c|^2 - r^2)^2: linear, hence no start needed, but biased to small
/// radii where points cover a cap only. N x 3 mm. Throws InputError below 4 points, for a coordinate that is
/// not finite, and for points in one plane.
[[nodiscard]] SphereFit fitSphereAlgebraic(const Points& points);

/// The sphere that minimises sum_i (|p_i - c| - r)^2, the orthogonal distances (Ahn, Rauh, Warnecke 2001), by
/// Gauss-Newton from the algebraic one. `radiusMm`: known and kept, or free if not given. Every point counts
/// alike. Throws as fitSphereAlgebraic.
[[nodiscard]] SphereFit fitSphere(const Points& points, std::optional<double> radiusMm = {});

/// The same where up to a third of the points belong to something else: the start is the best of 300 spheres
/// through four drawn points (least median of |distance|), then Tukey's weights, cut at 4.685 robust standard
/// deviations. Deterministic.
[[nodiscard]] SphereFit fitSphereRobust(const Points& points, std::optional<double> radiusMm = {});

}  // namespace falciform
