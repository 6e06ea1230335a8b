#include "Logic/Acquisition/VirtualScanner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Acquisition/ScanReturns.h"
#include "Logic/Acquisition/ScannerPhotograph.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/RasterMesh.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {
namespace {

constexpr double kTranslationMm = 300;  // half edge of the cube in which the scanner's origin is drawn
constexpr double kRadians = std::numbers::pi / 180;

/// The returns as points with noise, patches and colours, and where each stands in the raster.
Surface collect(const ScanScene& scene, const std::vector<ScanReturn>& returns,
                const VirtualScannerSettings& settings, const ScanFaultSettings& faults, Raster& raster) {
  const Surface& surface = scene.surface;
  Surface scan;
  Index count = 0;
  for (const ScanReturn& r : returns) count += r.triangle >= 0;
  scan.points.resize(count, 3);
  scan.colours.resize(count, 3);
  scan.patchNames = surface.patchNames;
  const bool labelled = !scene.structure.empty() || faults.smoke > 0;
  if (labelled) scan.arrays[structure::kArray].setZero(count);
  int next = 0;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    const ScanReturn& r = returns[i];
    if (r.triangle < 0) continue;
    raster.point[i] = next;
    raster.range[i] = r.range;
    // One stream a ray: the noise depends on the seed and the ray alone.
    Draws draws(static_cast<std::uint64_t>(settings.seed), 1000 + i);
    const double noise =
        settings.noiseMm *
        (faults.noiseGrowsWithRange ? rangeNoiseMm(r.range) / rangeNoiseMm(settings.distanceMm) : 1.0);
    scan.points.row(next) = (r.place + noise * draws.normal() * r.direction).transpose();
    const int label = r.structure == structure::kSmoke
                          ? patch::kNone
                          : surface.patchAt(nearestCorner(surface, r.triangle, r.place));
    if (!surface.patch.empty()) scan.patch.push_back(label);
    if (labelled) scan.arrays[structure::kArray][next] = r.structure;
    const auto rgb = sceneColour(r.structure, r.place, label);
    scan.colours.row(next) << rgb[0], rgb[1], rgb[2];
    ++next;
  }
  return scan;
}

/// Points of no triangle are speckle at the rim: a scanner's software drops them too.
Surface withoutSpeckle(const Surface& scan) {
  std::vector<char> used(static_cast<std::size_t>(scan.size()));
  for (const int v : scan.triangles.reshaped()) used[static_cast<std::size_t>(v)] = 1;
  std::vector<int> keep;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) keep.push_back(static_cast<int>(i));
  return subset(scan, keep);
}

}  // namespace

double rangeNoiseMm(double distanceMm) { return 0.3 + (1.0 - 0.3) * (distanceMm - 300) / (800 - 300); }

VirtualScan scanSurface(const Surface& surface, const VirtualScannerSettings& settings,
                        const Progress& progress) {
  return scanSurface(surface, centroid(surface.points), settings, {}, progress);
}

VirtualScan scanSurface(const Surface& surface, const Vector3d& lookAt,
                        const VirtualScannerSettings& settings, const ScanFaultSettings& faults,
                        const Progress& progress) {
  checkSettings(settings);
  checkSettings(faults);
  const ScannerView view = aimScanner(lookAt, settings);
  const ScanScene scene = makeScanScene(surface, view, faults);
  const TriangleTree tree(scene.surface);
  const std::vector<ScanReturn> returns =
      castScan(scene, tree, view, settings.grazingDeg, faults, progress.part(0, 0.9));

  Raster raster{.rows = view.rows,
                .columns = view.columns,
                .point = std::vector<int>(returns.size(), -1),
                .range = std::vector<double>(returns.size()),
                .jump = 0};
  // As steep as the grazing limit allows, between diagonal neighbours; steeper is another part of the liver.
  const double steepest = std::tan(std::min(settings.grazingDeg, 80.0) * kRadians);
  raster.jump = std::sqrt(2.0) * steepest * view.step * settings.distanceMm;

  VirtualScan result;
  Surface seen = collect(scene, returns, settings, faults, raster);
  seen.triangles = rasterTriangles(raster);
  seen.normals = rasterNormals(raster, seen.points, view.eye);
  if (faults.smoke <= 0) seen = withoutSpeckle(seen);
  if (faults.photograph) photographScan(scene, tree, view, seen);
  if (seen.size() == 0)
    throw InputError(
        "the virtual scanner at azimuth " + std::to_string(settings.azimuthDeg) + " deg and " +
        std::to_string(settings.distanceMm) +
        " mm sees nothing of the surface; widen the field of view, refine the raster or turn the scanner");
  double area = 0;
  for (const ScanReturn& r : returns)
    if (r.structure == structure::kOrgan) area += r.areaMm2;
  result.coverage = std::min(area / organArea(scene), 1.0);

  Draws draws(static_cast<std::uint64_t>(settings.seed), 4);
  result.scanFromPreop.linear() = draws.rotation().toRotationMatrix();
  for (int k = 0; k < 3; ++k)
    result.scanFromPreop.translation()[k] = draws.uniform(-kTranslationMm, kTranslationMm);
  result.scan = transformed(seen, result.scanFromPreop, "scanner");
  progress.report(1);
  return result;
}

}  // namespace falciform
