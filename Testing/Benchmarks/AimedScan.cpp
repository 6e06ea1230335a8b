#include "Testing/Benchmarks/AimedScan.h"

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::bench {

namespace {

constexpr int kCoarseStride = 4;  // while the window is sought
constexpr double kSecondStationDeg = 75;

Station drawStation(const Surface& surface, Draws& draws) {
  Station station;
  station.scanner.azimuthDeg = draws.uniform(-10, 40);
  station.scanner.elevationDeg = draws.uniform(-45, 0);
  station.scanner.fieldOfViewDeg = 45;  // the whole liver, wherever it is aimed at
  station.scanner.windowShare = 1;
  for (const int label : {patch::kFalciform, patch::kInferiorRidge}) {
    const std::vector<int> ids = pointsOfPatch(surface, label);
    for (const int i : ids)
      station.lookAt += 0.5 / static_cast<double>(ids.size()) * surface.points.row(i).transpose();
  }
  station.lookAt += 15 * draws.normal3();
  return station;
}

VirtualScan scanOne(const Station& station, const Surface& surface, double noiseMm, int stride, int seed) {
  VirtualScannerSettings settings = station.scanner;
  settings.noiseMm = noiseMm;
  settings.stride = stride;
  settings.seed = seed;
  return scanSurface(surface, station.lookAt, settings, {});
}

/// Cuts the window of the last station, to 1 %, so that all together see `share`; leaves it open if they do
/// not. Returns whether they do.
bool cutWindow(std::vector<Station>& stations, const Surface& surface, double share) {
  const auto coverage = [&](double window) {
    stations.back().scanner.windowShare = window;
    return scanFrom(stations, surface, 0, kCoarseStride, 1).coverage;
  };
  double low = 0.05, high = 1;
  if (coverage(high) < share) return false;
  while (high - low > 0.01) {
    const double middle = 0.5 * (low + high);
    (coverage(middle) < share ? low : high) = middle;
  }
  stations.back().scanner.windowShare = high;
  return true;
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

std::vector<Station> aimStations(const Surface& surface, double visibleShare, Draws& draws) {
  std::vector<Station> stations{drawStation(surface, draws)};
  if (cutWindow(stations, surface, visibleShare)) return stations;
  stations.push_back(stations.front());
  stations.back().scanner.azimuthDeg -= kSecondStationDeg;
  cutWindow(stations, surface, visibleShare);
  return stations;
}

VirtualScan scanFrom(const std::vector<Station>& stations, const Surface& surface, double noiseMm, int stride,
                     int seed) {
  VirtualScan seen = scanOne(stations.front(), surface, noiseMm, stride, seed);
  for (std::size_t k = 1; k < stations.size(); ++k)
    seen = joined(surface, seen, scanOne(stations[k], surface, noiseMm, stride, seed));
  return seen;
}

}  // namespace falciform::bench
