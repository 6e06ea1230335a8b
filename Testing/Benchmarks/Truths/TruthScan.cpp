#include "Testing/Benchmarks/Truths/TruthScan.h"

#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::bench {
namespace {

constexpr std::uint64_t kOutliers = 200, kScannerSeed = 201, kLookAt = 202;  // streams

}  // namespace

TruthScan scanTruth(const Surface& moved, const ScannerPlan& plan) {
  VirtualScannerSettings scanner;
  scanner.azimuthDeg = plan.azimuthDeg;
  scanner.elevationDeg = plan.elevationDeg;
  scanner.distanceMm = plan.distanceMm;
  scanner.noiseMm = plan.noiseMm;
  scanner.seed = static_cast<int>(Draws(plan.seed, kScannerSeed).uniform(0, 2e9));
  Draws aim(plan.seed, kLookAt);
  const Vector3d lookAt = centroid(moved.points) + 15 * aim.normal3();
  VirtualScan seen;
  double low = 0.1, high = 1;
  for (int halving = 0; halving < 8; ++halving) {
    scanner.windowShare = halving == 0 ? high : (low + high) / 2;
    seen = scanSurface(moved, lookAt, scanner, {});
    if (halving == 0 && seen.coverage < plan.coverage) break;  // the whole view shows no more
    (seen.coverage < plan.coverage ? low : high) = scanner.windowShare;
  }

  TruthScan result{
      .scan = std::move(seen.scan), .scannerFromPreop = seen.scanFromPreop, .coverage = seen.coverage};
  if (!plan.raster) result.scan.triangles.resize(0, 3);
  result.scan.normals.resize(0, 3);
  result.scan.colours.resize(0, 3);
  const Vector3d eye = result.scannerFromPreop * Vector3d(lookAt + plan.distanceMm * towardsScanner(scanner));
  Draws draws(plan.seed, kOutliers);
  for (Index i = 0; i < result.scan.size(); ++i) {
    if (draws.uniform() >= plan.outlierShare) continue;
    const Vector3d place = result.scan.points.row(i).transpose();
    result.scan.points.row(i) += (draws.uniform(5, 40) * (eye - place).normalized()).transpose();
  }
  return result;
}

}  // namespace falciform::bench
