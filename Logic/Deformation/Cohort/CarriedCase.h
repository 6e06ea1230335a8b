#pragma once
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"
#include "Logic/Deformation/Normalisation/LiverRegistration.h"

namespace falciform {

/// Values at a surface's vertices (N x k, NaN where there is none) at other places: at the closest place of
/// the surface, by barycentric weights. NaN where that is farther than `reachMm`, or a vertex with a share in
/// it has no value. Throws InputError for a surface without triangles or of another number of vertices.
[[nodiscard]] Eigen::MatrixXd valuesAt(const Surface& surface, const Eigen::MatrixXd& values,
                                       const Points& places, double reachMm);

/// One patient's values on the target liver (METHODS 3.4).
struct CarriedCase {
  Eigen::MatrixXd values;                   ///< target vertices x k; NaN where not covered
  VectorXd sourceToTarget, targetToSource;  ///< mm, as SurfaceErrors; empty of the target itself
  double leastDeterminant = 1;              ///< of the map over the target's vertices; above 0: no fold
};

/// A place of the target without a counterpart in the source this near, once the livers lie on each other,
/// has no value: one patient has a lobe there that the other lacks.
inline constexpr double kCounterpartMm = 5;

/// Registers the two livers and carries values at the source's vertices over. Throws InputError as
/// registerLivers.
[[nodiscard]] CarriedCase carryCase(const Surface& target, const Surface& source,
                                    const Eigen::MatrixXd& values, const NormalisationSettings& settings = {},
                                    const Progress& progress = {});

/// How far each vertex has moved along its outward normal, mm, beside the rigid motion that explains most of
/// all vertices' motion: what no rigid registration can take away. `moved`: where the surface's vertices are
/// now, in any frame.
[[nodiscard]] VectorXd normalDisplacement(const Surface& surface, const Points& moved);

}  // namespace falciform
