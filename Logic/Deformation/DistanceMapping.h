#pragma once
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Results.h"
#include "Logic/Core/Settings.h"

namespace falciform {

struct DistanceSettings {
  double reachMm = 10;         ///< a place is covered if the other surface lies within this
  double normalLimitDeg = 80;  ///< and the two normals differ by less than this (where both have normals)
  double curvatureRadiusMm =
      10;  ///< neighbourhood of a place's curvature, on both surfaces; 0: none is measured
};

template <class Visitor>
void describe(DistanceSettings& s, Visitor&& field) {
  field(FieldInfo{"reachMm", "Reach", "mm", 0.1, 200,
                  "A place is covered if the scan comes this near; beyond it there is no value."},
        s.reachMm);
  field(FieldInfo{"normalLimitDeg", "Normal limit", "deg", 1, 180,
                  "Opposed surfaces do not cover each other: largest angle between normals."},
        s.normalLimitDeg);
  field(FieldInfo{"curvatureRadiusMm", "Curvature radius", "mm", 0, 50,
                  "Curvature is fitted to all points this near, on both surfaces alike; 0: no curvature."},
        s.curvatureRadiusMm);
}

/// Signed distance where covered, NaN elsewhere, on both sides (thesis ch. IV; METHODS 3.1). `scanFromPreop`
/// brings the pre-op surface into the scan's frame. Sign: positive where the scan lies outside the pre-op
/// surface. At scan points: exact point to triangle. At pre-op vertices: to the scan's triangles, or its
/// points if it is a cloud; a place whose nearest scan place is on the scan's border and beyond it sideways
/// is not covered. Beside it, unless the curvature radius is 0, mean curvature and its difference by closest
/// point, scan less pre-op. Figures of regions are by patch and, where the pre-op surface carries an array
/// `couinaud_segment`, by segment; a scan point is of the segment of the place nearest to it. Throws
/// InputError if the pre-op surface has no triangles or the scan no points.
[[nodiscard]] DistanceMap mapDistances(const Surface& preop, const Surface& scan,
                                       const Isometry3d& scanFromPreop, const DistanceSettings& settings = {},
                                       const Progress& progress = {});

/// Over the values that are not NaN.
[[nodiscard]] DistanceStatistics distanceStatistics(const VectorXd& values);

}  // namespace falciform
