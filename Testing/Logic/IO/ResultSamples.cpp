#include "Testing/Logic/IO/ResultSamples.h"

#include <limits>

#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

RegistrationResult sampleRegistration() {
  RegistrationResult result;
  result.scanFromPreop = randomMotion(3);
  result.rmsMm = 1.1;
  result.weightedRmsMm = 1.2;
  result.meanMm = 0.9;
  result.p95Mm = 2.3;
  result.patchRmsMm = {{1, 0.5}, {2, 0.7}};
  result.coverage = 0.31;
  result.expectedErrorMeanMm = 2.5;
  result.rotationDeg = 12.5;
  result.translationMm = 33.25;
  result.iterations = 2;
  result.converged = true;
  result.stopReason = "moved less than 0.001 mm";
  result.history = {{1, 5.5, 1000, 12, randomMotion(4)}, {2, 1.1, 25, 0.125, randomMotion(5)}};
  result.basins = {{randomMotion(6), 0.4, 7}};
  result.warnings = {"coverage is low (0.31)"};
  result.scanPoints = 1234;
  result.preopPoints = 5678;
  result.seconds = 1.5;
  return result;
}

DistanceMap sampleDistance() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  DistanceMap map;
  map.preop = fullSurface();
  map.preop.frame = "scanner";
  map.preop.patchNames = {{3, "hilum, left"}};
  map.preop.arrays = {{kSignedDistance, VectorXd::LinSpaced(map.preop.size(), -1, 2.5)}};
  map.preop.arrays[kSignedDistance][0] = kNone;  // not covered
  map.scan = map.preop;
  map.scan.triangles.resize(0, 3);
  map.preopAll = {4, 1.25, 0.5, 1, 2, -1, 2.5, 1.5, 1.1};
  map.preopByPatch = {{1, map.preopAll}, {3, map.preopAll}};
  map.preopByPatch[1].count = map.preopByPatch[3].count = 2;
  map.scanAll = {0, kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};
  map.coverage = 0.5;
  const DistanceStatistics bend{3, 0.25, 0.125, 0.25, 0.5, -0.5, 0.75, 0.5, 0.375};
  map.preopRegions = {{RegionFigures::Kind::All, 0, "all", 100, 0.5, map.preopAll, bend},
                      {RegionFigures::Kind::Patch, 3, "hilum, left", 20, 1, map.preopByPatch[3], map.scanAll},
                      {RegionFigures::Kind::Segment, 4, "segment IV", 40, 0, map.scanAll, map.scanAll}};
  map.scanRegions = {{RegionFigures::Kind::All, 0, "all", kNone, 0, map.scanAll, map.scanAll}};
  return map;
}

}  // namespace falciform::test
