#include "Logic/Acquisition/ScanReturns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kSmokeHeight = 25;  // mm over the surface, the mean of a falling density
constexpr double kSameSpot = 0.05;   // mm: two rays to one place of a mesh, by rounding

/// Whether the laser reaches a place that the camera sees.
bool lit(const TriangleTree& tree, const Vector3d& laser, const ScanReturn& seen) {
  const Vector3d way = seen.place - laser;
  if (tree.triangleNormal(seen.triangle).dot(way) >= 0) return false;
  const auto hit = tree.cast(laser, way);
  return !hit || hit->distance > way.norm() - kSameSpot;
}

/// What the faults leave of a return.
void spoil(ScanReturn& seen, double facing, double flattest, const ScanFaultSettings& faults,
           std::uint64_t ray) {
  Draws draws(static_cast<std::uint64_t>(faults.faultSeed), (2ULL << 40) + ray);
  const double loss = (1 - facing) / std::max(1 - flattest, 1e-9);
  if (draws.uniform() < faults.dropout * loss * loss) {
    seen.triangle = -1;
    return;
  }
  if (draws.uniform() < faults.smoke) {
    const double height = -kSmokeHeight * std::log(1 - draws.uniform());
    seen.range = std::max(seen.range - height, 0.5 * seen.range);
    seen.structure = structure::kSmoke;
    seen.areaMm2 = 0;
  }
}

}  // namespace

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

std::vector<ScanReturn> castScan(const ScanScene& scene, const TriangleTree& tree, const ScannerView& view,
                                 double grazingDeg, const ScanFaultSettings& faults,
                                 const Progress& progress) {
  const auto columns = static_cast<std::size_t>(view.columns);
  std::vector<ScanReturn> returns(static_cast<std::size_t>(view.rows) * columns);
  const double flattest = std::cos(grazingDeg * kRadians);
  const Vector3d laser = view.eye + faults.baselineMm * view.right;
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
          ScanReturn seen{.triangle = hit->triangle,
                          .range = hit->distance,
                          .areaMm2 = hit->distance * hit->distance * solidAngle / facing,
                          .place = hit->point,
                          .direction = direction};
          if (!scene.structure.empty())
            seen.structure = scene.structure[static_cast<std::size_t>(tree.vertexOf(hit->triangle, 0))];
          if (faults.baselineMm > 0 && !lit(tree, laser, seen)) continue;
          const std::size_t at = static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column);
          if (faults.dropout > 0 || faults.smoke > 0) spoil(seen, facing, flattest, faults, at);
          if (seen.structure == structure::kSmoke) seen.place = view.eye + seen.range * direction;
          if (seen.triangle >= 0) returns[at] = seen;
        }
    });
  }
  return returns;
}

}  // namespace falciform
