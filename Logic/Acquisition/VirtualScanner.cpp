#include "Logic/Acquisition/VirtualScanner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Acquisition/RasterMesh.h"
#include "Logic/Acquisition/TissueColour.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {
namespace {

constexpr double kTranslationMm = 300;  // half edge of the cube in which the scanner's origin is drawn
constexpr double kRadians = std::numbers::pi / 180;

/// A pinhole at `eye` that looks along `forward`; rays are forward + u right + v down.
struct View {
  Vector3d eye, forward, right, down;
  int rows = 0, columns = 0;  ///< kept lines and samples
  double step = 0;            ///< of u and v between neighbours that are kept
  double u0 = 0, v0 = 0;      ///< of the first kept ray

  [[nodiscard]] Vector3d ray(int row, int column) const {
    return forward + (u0 + column * step) * right + (v0 + row * step) * down;
  }
};

View aim(const Vector3d& lookAt, const VirtualScannerSettings& s) {
  View view;
  const Vector3d outwards = towardsScanner(s);
  view.eye = lookAt + s.distanceMm * outwards;
  view.forward = -outwards;
  view.right = view.forward.cross(Vector3d::UnitZ()).normalized();
  view.down = view.forward.cross(view.right);
  // The window keeps the central share of lines and samples, the stride every n-th of these.
  const auto kept = [&](int count) {
    return (static_cast<int>(std::ceil(count * s.windowShare)) + s.stride - 1) / s.stride;
  };
  view.rows = kept(s.lines);
  view.columns = kept(s.samples);
  const double side = 2 * std::tan(0.5 * s.fieldOfViewDeg * kRadians);
  view.step = side / std::max(s.lines, s.samples) * s.stride;
  view.u0 = -0.5 * view.step * (view.columns - 1);
  view.v0 = -0.5 * view.step * (view.rows - 1);
  return view;
}

/// What one ray found: nothing if triangle is -1.
struct Return {
  int triangle = -1;
  double range = 0;    ///< mm, without noise
  double areaMm2 = 0;  ///< of the surface that this ray stands for
  Vector3d place = Vector3d::Zero(), direction = Vector3d::Zero();
};

std::vector<Return> castAll(const TriangleTree& tree, const View& view, double grazingDeg,
                            const Progress& progress) {
  std::vector<Return> returns(static_cast<std::size_t>(view.rows) * static_cast<std::size_t>(view.columns));
  const double flattest = std::cos(grazingDeg * kRadians);
  constexpr int kBand = 16;  // rows between two reports
  for (int band = 0; band < view.rows; band += kBand) {
    progress.report(static_cast<double>(band) / view.rows, "Scanning");
    const auto rows = static_cast<std::size_t>(std::min(kBand, view.rows - band));
    forEachChunk(rows, 1, [&](std::size_t begin, std::size_t end) {
      for (int row = band + static_cast<int>(begin); row < band + static_cast<int>(end); ++row)
        for (int column = 0; column < view.columns; ++column) {
          const Vector3d ray = view.ray(row, column), direction = ray.normalized();
          const auto hit = tree.cast(view.eye, direction);
          if (!hit) continue;
          const double facing = -tree.triangleNormal(hit->triangle).dot(direction);
          if (facing <= 0 || facing < flattest) continue;
          // A step du dv of the raster spans du dv / |ray|^3 of solid angle.
          const double solidAngle = view.step * view.step / std::pow(ray.norm(), 3);
          returns[static_cast<std::size_t>(row) * static_cast<std::size_t>(view.columns) +
                  static_cast<std::size_t>(column)] = {hit->triangle, hit->distance,
                                                       hit->distance * hit->distance * solidAngle / facing,
                                                       hit->point, direction};
        }
    });
  }
  return returns;
}

int nearestCorner(const Surface& surface, int triangle, const Vector3d& place) {
  int best = surface.triangles(triangle, 0);
  for (int corner = 1; corner < 3; ++corner) {
    const int v = surface.triangles(triangle, corner);
    if ((surface.points.row(v).transpose() - place).squaredNorm() <
        (surface.points.row(best).transpose() - place).squaredNorm())
      best = v;
  }
  return best;
}

/// The returns as points with noise, patches and colours, and where each stands in the raster.
Surface collect(const Surface& surface, const std::vector<Return>& returns,
                const VirtualScannerSettings& settings, Raster& raster) {
  Surface scan;
  Index count = 0;
  for (const Return& r : returns) count += r.triangle >= 0;
  scan.points.resize(count, 3);
  scan.colours.resize(count, 3);
  scan.patchNames = surface.patchNames;
  int next = 0;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    const Return& r = returns[i];
    if (r.triangle < 0) continue;
    raster.point[i] = next;
    raster.range[i] = r.range;
    // One stream a ray: the noise depends on the seed and the ray alone.
    Draws draws(static_cast<std::uint64_t>(settings.seed), 1000 + i);
    scan.points.row(next) = (r.place + settings.noiseMm * draws.normal() * r.direction).transpose();
    const int label = surface.patchAt(nearestCorner(surface, r.triangle, r.place));
    if (!surface.patch.empty()) scan.patch.push_back(label);
    const auto rgb = tissueColour(r.place, label);
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

Vector3d towardsScanner(const VirtualScannerSettings& s) {
  const double az = s.azimuthDeg * kRadians, el = s.elevationDeg * kRadians;
  // LPS: the front is -y, the patient's right is -x, the head is +z.
  return {-std::sin(az) * std::cos(el), -std::cos(az) * std::cos(el), std::sin(el)};
}

VirtualScan scanSurface(const Surface& surface, const VirtualScannerSettings& settings,
                        const Progress& progress) {
  return scanSurface(surface, centroid(surface.points), settings, progress);
}

VirtualScan scanSurface(const Surface& surface, const Vector3d& lookAt,
                        const VirtualScannerSettings& settings, const Progress& progress) {
  checkSettings(settings);
  const TriangleTree tree(surface);
  const View view = aim(lookAt, settings);
  const std::vector<Return> returns = castAll(tree, view, settings.grazingDeg, progress.part(0, 0.9));

  Raster raster{.rows = view.rows,
                .columns = view.columns,
                .point = std::vector<int>(returns.size(), -1),
                .range = std::vector<double>(returns.size()),
                .jump = 0};
  // As steep as the grazing limit allows, between diagonal neighbours; steeper is another part of the liver.
  const double steepest = std::tan(std::min(settings.grazingDeg, 80.0) * kRadians);
  raster.jump = std::sqrt(2.0) * steepest * view.step * settings.distanceMm;

  VirtualScan result;
  Surface seen = collect(surface, returns, settings, raster);
  seen.triangles = rasterTriangles(raster);
  seen.normals = rasterNormals(raster, seen.points, view.eye);
  seen = withoutSpeckle(seen);
  if (seen.size() == 0)
    throw InputError(
        "the virtual scanner at azimuth " + std::to_string(settings.azimuthDeg) + " deg and " +
        std::to_string(settings.distanceMm) +
        " mm sees nothing of the surface; widen the field of view, refine the raster or turn the scanner");
  double area = 0;
  for (const Return& r : returns) area += r.areaMm2;
  result.coverage = std::min(area / falciform::area(surface), 1.0);

  Draws draws(static_cast<std::uint64_t>(settings.seed), 4);
  result.scanFromPreop.linear() = draws.rotation().toRotationMatrix();
  for (int k = 0; k < 3; ++k)
    result.scanFromPreop.translation()[k] = draws.uniform(-kTranslationMm, kTranslationMm);
  result.scan = transformed(seen, result.scanFromPreop, "scanner");
  progress.report(1);
  return result;
}

}  // namespace falciform
