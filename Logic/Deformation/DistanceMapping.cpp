#include "Logic/Deformation/DistanceMapping.h"

#include <algorithm>
#include <functional>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/RegionStatistics.h"
#include "Logic/Deformation/SurfaceComparison.h"
#include "Logic/Geometry/Curvature.h"

namespace falciform {

namespace {

/// What is measured on one side.
struct SideMeasured {
  VectorXd distance, curvatureDifference, segment;
};

/// Measures `count` items on all threads, with progress between blocks.
SideMeasured measureAll(Index count, const std::function<PlaceMeasured(Index)>& measure,
                        const Progress& progress, std::string_view stage) {
  constexpr Index block = 16384;
  constexpr std::size_t chunk = 256;
  SideMeasured side{VectorXd(count), VectorXd(count), VectorXd(count)};
  for (Index from = 0; from < count; from += block) {
    progress.report(static_cast<double>(from) / static_cast<double>(count), stage);
    const Index to = std::min(count, from + block);
    forEachChunk(static_cast<std::size_t>(to - from), chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index item = from + static_cast<Index>(i);
        const PlaceMeasured place = measure(item);
        side.distance[item] = place.distanceMm;
        side.curvatureDifference[item] = place.curvatureDifferencePerMm;
        side.segment[item] = place.segment;
      }
    });
  }
  progress.report(1, stage);
  return side;
}

/// Puts what was measured on the side as arrays, and into figures.
void keep(SideMeasured measured, const VectorXd& curvature, bool segments, Surface& side,
          std::vector<RegionFigures>& regions, DistanceStatistics& all,
          std::map<int, DistanceStatistics>& byPatch) {
  side.arrays[kSignedDistance] = std::move(measured.distance);
  side.arrays.erase(kCurvatureDifference);  // of a map before
  side.arrays.erase(kMeanCurvature);
  if (curvature.size() > 0) {
    side.arrays[kMeanCurvature] = curvature;
    side.arrays[kCurvatureDifference] = std::move(measured.curvatureDifference);
  }
  if (segments) side.arrays[kCouinaudSegment] = std::move(measured.segment);
  regions = regionStatistics(side);
  for (const RegionFigures& region : regions) {
    if (region.kind == RegionFigures::Kind::All) all = region.distance;
    if (region.kind == RegionFigures::Kind::Patch) byPatch[region.label] = region.distance;
  }
}

}  // namespace

DistanceMap mapDistances(const Surface& preop, const Surface& scan, const Isometry3d& scanFromPreop,
                         const DistanceSettings& settings, const Progress& progress) {
  checkSettings(settings);
  if (preop.triangles.rows() == 0)
    throw InputError("the pre-operative surface has no triangles; import it as a surface, not as a cloud");
  if (scan.size() == 0) throw InputError("the scan has no points; open another scan");
  if (!scanFromPreop.matrix().allFinite())
    throw InputError("the registration holds a value that is not a number; register again");

  progress.report(0, "Preparing surfaces");
  DistanceMap map;
  map.preop = transformed(preop, scanFromPreop, scan.frame);
  map.scan = scan;
  const SurfaceComparison comparison(map.preop, map.scan, settings);
  SideMeasured atPreop = measureAll(
      preop.size(), [&](Index i) { return comparison.atPreopVertex(i); }, progress.part(0.1, 0.55),
      "Measuring from the pre-operative surface");
  SideMeasured atScan = measureAll(
      scan.size(), [&](Index i) { return comparison.atScanPoint(i); }, progress.part(0.55, 1),
      "Measuring from the scan");

  const bool segments = preop.arrays.count(kCouinaudSegment) > 0;
  keep(std::move(atPreop), comparison.preopCurvature(), segments, map.preop, map.preopRegions, map.preopAll,
       map.preopByPatch);
  keep(std::move(atScan), comparison.scanCurvature(), segments, map.scan, map.scanRegions, map.scanAll,
       map.scanByPatch);
  map.coverage = map.preopRegions.front().coverage > 0 ? map.preopRegions.front().coverage : 0;
  return map;
}

}  // namespace falciform
