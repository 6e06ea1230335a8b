#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Landmarks.h"
#include "Logic/Core/Types.h"

namespace falciform {

/// The rigid motion that minimises sum_i w_i |target_i - T source_i|^2: closed form by SVD, det = +1 enforced
/// (Arun 1987; weighted, Maurer 1998; thesis Eq. (III.2) for fixed correspondences). N x 3 mm each, rows
/// correspond; weights N values > 0 or empty. No checks: use registerPoints for user input.
[[nodiscard]] Isometry3d fitRigid(const Points& source, const Points& target, const VectorXd& weights = {});

/// The closed form itself: the motion from the two weighted centroids, mm, and the 3 x 3 cross-covariance
/// sum_i w_i (source_i - s)(target_i - t)^T.
[[nodiscard]] Isometry3d rigidFromMoments(const Vector3d& sourceCentroid, const Vector3d& targetCentroid,
                                          const Matrix3d& cross);

/// The same motion by Horn's unit quaternion (1987): the answer of fitRigid by another road.
[[nodiscard]] Isometry3d fitRigidHorn(const Points& source, const Points& target,
                                      const VectorXd& weights = {});

struct PointRegistrationResult {
  Isometry3d targetFromSource = Isometry3d::Identity();
  double freMm = 0;                   ///< root mean square fiducial registration error
  VectorXd freByPointMm;              ///< N values
  double fleEstimateMm = 0;           ///< fiducial localisation error, from FRE^2 = (1 - 2/N) FLE^2
  std::vector<std::string> warnings;  ///< ambiguous configurations (a near-symmetric or near-planar set)
};

/// Why registerPoints would refuse these lists, with the remedy; empty where it would not.
[[nodiscard]] std::string pointRegistrationProblem(const Landmarks& source, const Landmarks& target);

/// Point-based registration of landmarks, matched by name where all names agree, else by order. Throws
/// InputError for fewer than 3 points, unequal lists and collinear points.
[[nodiscard]] PointRegistrationResult registerPoints(const Landmarks& source, const Landmarks& target);

/// Expected squared target error is FLE^2/N (1 + 1/3 sum_k d_k^2/f_k^2) (Fitzpatrick, West, Maurer 1998, Eq.
/// (46)): returns its root, mm, at `targetInSource`. `source`: N x 3 fiducials.
[[nodiscard]] double predictedTre(const Points& source, double fleMm, const Vector3d& targetInSource);

/// |T p_i - q_i| for each row, mm.
[[nodiscard]] VectorXd targetErrors(const Points& source, const Points& target,
                                    const Isometry3d& targetFromSource);

}  // namespace falciform
