#include "Testing/Benchmarks/AimedScan.h"

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::bench {

namespace {

constexpr int kCoarseStride = 4;  // while the window is sought
constexpr double kSecondStationDeg = 75;

struct Aim {
  VirtualScannerSettings scanner;
  Vector3d lookAt = Vector3d::Zero();

  [[nodiscard]] VirtualScan scan(const Surface& surface, int stride, double window) const {
    VirtualScannerSettings settings = scanner;
    settings.stride = stride;
    settings.windowShare = window;
    return scanSurface(surface, lookAt, settings);
  }
};

Aim drawAim(const Surface& surface, const AimedView& view, int seed, Draws& draws) {
  Aim aim;
  aim.scanner.azimuthDeg = draws.uniform(-10, 40);
  aim.scanner.elevationDeg = draws.uniform(-45, 0);
  aim.scanner.distanceMm = 900;  // the farther away, the more of a round body is seen
  aim.scanner.fieldOfViewDeg = 24;
  aim.scanner.grazingDeg = 85;
  aim.scanner.noiseMm = view.noiseMm;
  aim.scanner.seed = seed;
  for (const int label : {patch::kFalciform, patch::kInferiorRidge}) {
    const std::vector<int> ids = pointsOfPatch(surface, label);
    for (const int i : ids)
      aim.lookAt += 0.5 / static_cast<double>(ids.size()) * surface.points.row(i).transpose();
  }
  aim.lookAt += 15 * draws.normal3();
  return aim;
}

/// The smallest window, to 1 %, for which `coverage(window)` reaches `share`; 1 if none does.
template <class Coverage>
double windowFor(double share, Coverage&& coverage) {
  double low = 0.05, high = 1;
  if (coverage(high) < share) return high;
  while (high - low > 0.01) {
    const double middle = 0.5 * (low + high);
    (coverage(middle) < share ? low : high) = middle;
  }
  return high;
}

/// Both scans, which share the scanner's frame, as one cloud.
VirtualScan joined(const Surface& surface, const VirtualScan& a, const VirtualScan& b) {
  constexpr double kReachMm = 3;  // about the spacing of the coarse raster
  VirtualScan both;
  both.scanFromPreop = a.scanFromPreop;
  both.scan.frame = a.scan.frame;
  both.scan.patchNames = a.scan.patchNames;
  both.scan.patch = a.scan.patch;
  both.scan.patch.insert(both.scan.patch.end(), b.scan.patch.begin(), b.scan.patch.end());
  both.scan.points.resize(a.scan.size() + b.scan.size(), 3);
  both.scan.points << a.scan.points, b.scan.points;
  const KdTree tree(transformed(both.scan.points, both.scanFromPreop.inverse()));
  const VectorXd areas = vertexAreas(surface);
  for (Index i = 0; i < surface.size(); ++i)
    if (tree.nearest(surface.points.row(i).transpose(), kReachMm * kReachMm).index >= 0)
      both.coverage += areas[i];
  both.coverage /= areas.sum();
  return both;
}

}  // namespace

VirtualScan scanAimed(const Surface& surface, const AimedView& view, int seed, Draws& draws) {
  const Aim aim = drawAim(surface, view, seed, draws);
  const double window =
      windowFor(view.visibleShare, [&](double w) { return aim.scan(surface, kCoarseStride, w).coverage; });
  VirtualScan seen = aim.scan(surface, view.stride, window);
  if (window < 1 || seen.coverage >= view.visibleShare) return seen;
  Aim second = aim;
  second.scanner.azimuthDeg -= kSecondStationDeg;
  const double more = windowFor(view.visibleShare, [&](double w) {
    return joined(surface, seen, second.scan(surface, kCoarseStride, w)).coverage;
  });
  return joined(surface, seen, second.scan(surface, view.stride, more));
}

}  // namespace falciform::bench
