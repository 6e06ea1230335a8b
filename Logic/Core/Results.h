#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Core/Types.h"

namespace falciform {

// The results that steps hand to each other. Steps meet through these types, not through each other.

/// One iteration of a registration, for curves and reports.
struct IterationRecord {
  int iteration = 0;       ///< 1-based
  double rmsMm = 0;        ///< unweighted RMS of the closest-point distances before the step
  double patchWeight = 1;  ///< w_PBR of Eq. (III.3)
  double motionMm = 0;     ///< largest displacement of a scan point in this step
  Isometry3d preopFromScan = Isometry3d::Identity();  ///< pose after the step
};

/// Called after each iteration of the running start; for live curves. May run on a worker thread.
using IterationObserver = std::function<void(const IterationRecord&)>;

/// A pose that some starts led to: one local minimum of the robust residual.
struct RegistrationBasin {
  Isometry3d scanFromPreop = Isometry3d::Identity();
  double score = 0;  ///< robust residual in [0, 1] and what the bending costs, lower is better
                     ///< (Logic/Registration/ElasticFit.h)
  int starts = 0;    ///< how many starts ended here
};

/// What a non-rigid method makes of the pre-operative side.
struct RegistrationWarp {
  std::function<Points(const Points& preopMm)> scanFromPreop;  ///< any points of the pre-op side, to scan mm
  Points preopOnScan;                                          ///< the pre-op surface's points, scan mm
};

/// Where the scan lies on the pre-operative surface. Residuals are *fit*, not target error.
struct RegistrationResult {
  Isometry3d scanFromPreop = Isometry3d::Identity();  ///< maps pre-op LPS mm to scan mm
  double rmsMm = 0;                                   ///< unweighted RMS over all scan points, real distances
  double weightedRmsMm = 0;                           ///< with the patch weights of the last iteration
  double meanMm = 0, p95Mm = 0;
  /// Expected target error, mm, at a place in the pre-op frame: by how much this rigid pose may be off there,
  /// bending included. Empty where the method gives none.
  std::function<double(const Vector3d& preopMm)> expectedTargetErrorMm;
  double expectedErrorMeanMm = 0;        ///< root of its mean square over the organ; 0 where there is none
  std::optional<RegistrationWarp> warp;  ///< of a non-rigid method; all else here is of its rigid part
  std::map<int, double> patchRmsMm;  ///< per label: scan patch points to the same label of the pre-op surface
  double coverage = 0;       ///< share of the pre-op surface's area within reach of the scan, in [0, 1]
  double rotationDeg = 0;    ///< of the pose against the given start
  double translationMm = 0;  ///< of the scan's centroid against the given start
  int iterations = 0;
  bool converged = false;
  std::string stopReason;                 ///< in words
  std::vector<IterationRecord> history;   ///< of the start that won
  std::vector<RegistrationBasin> basins;  ///< best first; the result's own pose is basins[0]
  std::vector<std::string> warnings;      ///< in plain words
  Index scanPoints = 0, preopPoints = 0;
  double seconds = 0;
};

/// Mean, spread and range of a set of values, in their unit: mm of distances, 1/mm of curvature differences.
/// NaN when there is no value.
struct DistanceStatistics {
  Index count = 0;  ///< covered values
  double mean = 0, sd = 0, median = 0, p95Absolute = 0, min = 0, max = 0, rms = 0, meanAbsolute = 0;
};

/// What was measured on a region of one surface: on all of it, on a patch, or on a Couinaud segment. Places
/// that are not covered count in `areaMm2` and in nothing else.
struct RegionFigures {
  enum class Kind { All, Patch, Segment };
  Kind kind = Kind::All;
  int label = 0;        ///< of the patch or segment
  std::string name;     ///< "all", "falciform", "segment IV"
  double areaMm2 = 0;   ///< NaN of a cloud, which has none
  double coverage = 0;  ///< covered share of the area, or of a cloud's points, in [0, 1]; NaN of no points
  DistanceStatistics distance;             ///< mm
  DistanceStatistics curvatureDifference;  ///< 1/mm; of no values where it was not measured

  [[nodiscard]] double coveredAreaMm2() const { return areaMm2 > 0 ? areaMm2 * coverage : areaMm2; }
};

/// Signed distance between the two surfaces, on both sides: positive where the intra-operative surface lies
/// outside the pre-operative one; NaN where the scan does not reach. Array name on both:
/// `signed_distance_mm`. Beside it `curvature_difference_per_mm`: mean curvature of the intra-operative
/// surface less that of the pre-operative one, positive where it has become more convex; NaN near a scan's
/// border too.
struct DistanceMap {
  Surface preop;  ///< pre-op surface moved into the scan's frame, with the array
  Surface scan;   ///< scan with the array
  DistanceStatistics preopAll, scanAll;
  std::map<int, DistanceStatistics> preopByPatch, scanByPatch;  ///< by label
  std::vector<RegionFigures> preopRegions, scanRegions;  ///< all, then patches, then segments, by label
  double coverage = 0;  ///< covered share of the pre-op surface's area, in [0, 1]
};

inline constexpr char kSignedDistance[] = "signed_distance_mm";
inline constexpr char kCurvatureDifference[] = "curvature_difference_per_mm";
/// Couinaud segment of each point, 1 to 8; 0 or NaN: none.
inline constexpr char kCouinaudSegment[] = "couinaud_segment";
/// How far a point has moved, on a deformed surface.
inline constexpr char kDisplacement[] = "displacement_mm";

}  // namespace falciform
