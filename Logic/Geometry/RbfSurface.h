#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Geometry/RbfFit.h"

namespace falciform {

/// How a surface or scan is smoothed by radial basis functions.
struct RbfSurfaceSettings {
  double noiseMm = 0;       ///< standard deviation of the points across the surface; 0: found from the points
  double detailMm = 0;      ///< step of the finest functions; 0: two and a half times the points' spacing
  double edgeLengthMm = 0;  ///< mean length of the result's edges; 0: as many points as before
  double fillHolesMm = 10;  ///< gaps in the points up to so wide are closed
};

template <class Visitor>
void describe(RbfSurfaceSettings& s, Visitor&& field) {
  field(FieldInfo{"noiseMm", "Noise", "mm", 0, 20,
                  "Standard deviation of the points across the surface; 0 finds it from the points."},
        s.noiseMm);
  field(
      FieldInfo{
          "detailMm", "Detail", "mm", 0, 100,
          "Step between the finest functions: what is narrower than twice this is smoothed away; 0: two "
          "and a half times the points' spacing."},
      s.detailMm);
  field(FieldInfo{"edgeLengthMm", "Edge length", "mm", 0, 50,
                  "Mean length of the triangles' edges; 0 gives about as many points as before."},
        s.edgeLengthMm);
  field(FieldInfo{"fillHolesMm", "Fill holes", "mm", 0, 100, "Gaps in the points up to so wide are closed."},
        s.fillHolesMm);
}

struct RbfSurfaceResult {
  /// Regular triangles, analytic normals, array `mean_curvature_per_mm` from the function; patches, colours
  /// and arrays of the nearest point before.
  Surface surface;
  RbfFitResult fit;
  double edgeLengthMm = 0;          ///< aimed at
  double rmsMm = 0, largestMm = 0;  ///< of the points' distances from the function's zero
  Index filledPoints = 0;           ///< of the result that close gaps
  std::vector<std::string> warnings;
};

/// A smooth surface with regular sampling through the points of a surface, a scan or a cloud with normals
/// (thesis ch. II, IV: FastRBF). Where the points end, so does the surface. Throws InputError for a cloud
/// without normals, for too few points and for an edge length that would make more than 20 million
/// triangles. Results do not depend on the number of threads.
[[nodiscard]] RbfSurfaceResult smoothByRbf(const Surface& surface, const RbfSurfaceSettings& settings,
                                           const Progress& progress = {});

}  // namespace falciform
