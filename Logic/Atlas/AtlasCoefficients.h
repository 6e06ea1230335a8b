#pragma once
#include "Logic/Atlas/Atlas.h"

namespace falciform {

/// A scan's normal equations in an atlas's modes, for fixed correspondences: with U_j the 3 x rank modes at
/// scan point j's counterpart and d_j where the point lies from there, both mm.
struct ModalEquations {
  Eigen::MatrixXd square;      ///< rank x rank: sum_j w_j U_j' U_j
  VectorXd right;              ///< rank: sum_j w_j U_j' d_j
  double relativeError = 1;    ///< d_err of Eq. (V.18), coordinates centred
  double pointVariance = 1;    ///< of the residual's components as it is now, mm^2
  double pointsPerSample = 1;  ///< how many scan points are worth one independent measurement
};

/// Fitted coefficients, of the modes (rank) and of the atlas's members (M) that they are made of; members is
/// empty for fits that know no members.
struct AtlasCoefficients {
  VectorXd modes, members;
};

/// Eq. (V.16) with (V.17) as corrected: phi minimises the weighted residual plus beta^2 |phi|^2 over the M
/// members, beta^2 = lambda mean(diag S'WS) d_err^2. Solved among the modes, where |phi|^2 of the shortest
/// phi that makes coefficients c is c' (C'C)^-1 c: the same answer for a rank x rank system.
[[nodiscard]] AtlasCoefficients tikhonovCoefficients(const Atlas& atlas, const ModalEquations& equations,
                                                     double lambda);

/// Members with no negative share, shares summing to at most 1 (Dumpuri et al. 2007): the scan is between the
/// members and never beyond.
[[nodiscard]] AtlasCoefficients constrainedCoefficients(const Atlas& atlas, const ModalEquations& equations);

/// The most probable coefficients if members are draws from a normal distribution (Davatzikos et al. 2001):
/// mean of the members plus their principal components, the fewest that hold `varianceShare` of the variance,
/// each with its variance as prior.
class MemberStatistics {
 public:
  MemberStatistics(const Atlas& atlas, double varianceShare);
  [[nodiscard]] AtlasCoefficients mostProbable(const ModalEquations& equations) const;
  [[nodiscard]] Index components() const { return components_.cols(); }
  [[nodiscard]] const VectorXd& mean() const { return mean_; }

 private:
  VectorXd mean_;               ///< of the modes' coefficients
  Eigen::MatrixXd components_;  ///< rank x k, orthonormal
  VectorXd variances_;          ///< k, mm^2
};

}  // namespace falciform
