#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Curvature.h"

namespace falciform {

/// The two kinds of crest line of a surface (Monga et al. 1992): sharp edges and grooves.
enum class CrestKind { Ridge, Valley };

/// How sharp each vertex is for its kind, N values, 1/mm, at least 0: the largest principal curvature, or the
/// smallest with its sign changed. Values that are not known are 0.
[[nodiscard]] VectorXd crestCurvature(const Curvatures& curvatures, CrestKind kind);

/// The curvature of each vertex over the largest one within `reachMm` across the crest (along its direction
/// of curvature, within 37 degrees), N values in [0, 1]: 1 on the crest itself, 0 where it bends the other
/// way. `surface` is the one whose curvatures these are.
[[nodiscard]] VectorXd crestPeak(const Surface& surface, const Curvatures& curvatures, CrestKind kind,
                                 double reachMm);

/// What a step costs at each vertex for a path that is to keep to a ridge or a groove, N values in (0, 1]:
/// low on sharp crests, 1 where there is none. For polylines that snap: cost of an edge = its length x the
/// mean of its ends. `scaleMm` is the radius of the fit; throws InputError unless it is in [1, 50].
[[nodiscard]] VectorXd crestCost(const Surface& surface, CrestKind kind, double scaleMm = 8);

}  // namespace falciform
