#include "Logic/Acquisition/PhantomCt.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {
namespace {

// A voxel sees one voxel's edge to either side along each axis, with a weight that falls linearly, as the
// slice profile of a helical CT: in three parts, whose weights are the triangle's integrals.
constexpr double kPart[] = {-2.0 / 3, 0, 2.0 / 3}, kWeight[] = {2.0 / 9, 5.0 / 9, 2.0 / 9};
constexpr double kPartEdge = 2.0 / 3;
constexpr double kReach = 2;  // voxels: beyond, a distance of any slope up to 1.15 is free of the border

/// Share of a cube of edge `h` below the zero of a distance `d` at its middle, for planes of a mean tilt:
/// over all directions the cube is 1.5 h thick across the plane.
double shareInside(double d, double h) { return std::clamp(0.5 - d / (1.5 * h), 0.0, 1.0); }

double distanceToSpheres(const PhantomBody& body, const Vector3d& p) {
  double nearest = 1e9;
  for (const Vector3d& centre : body.spheres) nearest = std::min(nearest, (p - centre).norm());
  return nearest - body.sphereRadiusMm;
}

/// Share of the body in what the voxel at `middle` sees; `atMiddle` is the distance there.
template <class Distance>
double voxelShare(const Distance& distance, double atMiddle, const Vector3d& middle, double voxelMm) {
  if (std::abs(atMiddle) > kReach * voxelMm) return atMiddle < 0 ? 1 : 0;
  double share = 0;
  for (int n = 0; n < 27; ++n) {
    const int i = n % 3, j = n / 3 % 3, k = n / 9;
    const Vector3d part = middle + voxelMm * Vector3d(kPart[i], kPart[j], kPart[k]);
    share += kWeight[i] * kWeight[j] * kWeight[k] * shareInside(distance(part), kPartEdge * voxelMm);
  }
  return share;
}

/// What voxels see of the beads, by offset: of 1 mm each, so by their points and not by a distance.
std::unordered_map<std::size_t, double> beadShares(const Image& ct, const std::vector<Vector3d>& beads,
                                                   double voxelMm) {
  constexpr int kAcross = 11;  // points over a bead's diameter
  std::vector<Vector3d> ball;
  for (int n = 0; n < kAcross * kAcross * kAcross; ++n) {
    const Vector3d part(n % kAcross, n / kAcross % kAcross, n / (kAcross * kAcross));
    const Vector3d unit = ((part.array() + 0.5) / kAcross * 2 - 1).matrix();
    if (unit.norm() < 1) ball.emplace_back(kBeadRadiusMm * unit);
  }
  const double volume = 4.0 / 3 * std::numbers::pi * std::pow(kBeadRadiusMm / voxelMm, 3);
  const Matrix4d indexFromWorld = ct.worldFromIndex.inverse();
  std::unordered_map<std::size_t, double> shares;
  for (const Vector3d& bead : beads)
    for (const Vector3d& part : ball) {
      const Vector3d at = (indexFromWorld * (bead + part).homogeneous()).head<3>();
      const Vector3i low = at.array().floor().cast<int>();
      for (int n = 0; n < 8; ++n) {  // the falling weight of a voxel reaches the next middle to either side
        const Vector3i voxel = low + Vector3i(n & 1, n >> 1 & 1, n >> 2);
        if (voxel.minCoeff() < 0 || (ct.size - voxel).minCoeff() < 1) continue;
        const double weight = (1 - (at - voxel.cast<double>()).array().abs()).prod();
        shares[ct.offset(voxel.x(), voxel.y(), voxel.z())] +=
            volume * weight / static_cast<double>(ball.size());
      }
    }
  return shares;
}

}  // namespace

Image imagePhantom(const PhantomBody& body, double voxelMm, double noiseHu, int seed,
                   const Progress& progress) {
  const auto liver = [&](const Vector3d& p) { return body.liver.distance(p); };
  const auto spheres = [&](const Vector3d& p) { return distanceToSpheres(body, p); };
  Image ct = sampleDepth(liver, body.bounds(), voxelMm, progress.part(0, 0.3));  // depth first, then HU
  const auto rows = static_cast<std::size_t>(ct.size.y());
  const auto steel = beadShares(ct, body.beads, voxelMm);
  for (int k = 0; k < ct.size.z(); ++k) {
    progress.report(0.3 + 0.7 * k / ct.size.z(), "Imaging the phantom");
    forEachChunk(rows, 8, [&](std::size_t begin, std::size_t end) {
      for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j) {
        // One stream a row: the noise does not depend on the threads.
        Draws draws(static_cast<std::uint64_t>(seed),
                    (1ULL << 40) + static_cast<std::uint64_t>(k) * rows + static_cast<std::uint64_t>(j));
        for (int i = 0; i < ct.size.x(); ++i) {
          const Vector3d middle = ct.world(Vector3d(i, j, k));
          float& value = ct.at(i, j, k);
          const double silicone = voxelShare(liver, -static_cast<double>(value), middle, voxelMm);
          const double teflon = voxelShare(spheres, spheres(middle), middle, voxelMm);
          double hu = phantom::kAirHu + silicone * (phantom::kSiliconeHu - phantom::kAirHu) +
                      teflon * (phantom::kTeflonHu - phantom::kAirHu);
          if (const auto bead = steel.find(ct.offset(i, j, k)); bead != steel.end())
            hu += bead->second * (phantom::kSteelHu - phantom::kSiliconeHu);
          value =
              static_cast<float>(std::min(std::round(hu + noiseHu * draws.normal()), phantom::kLargestHu));
        }
      }
    });
  }
  return ct;
}

Surface siliconeSurface(const Image& ct) {
  Surface surface = largestPiece(isosurface(ct, phantom::kSiliconeLevel));
  surface.normals = vertexNormals(surface);
  return surface;
}

LabelMap labelPhantom(const Image& ct, const std::vector<Vector3d>& spheres, double sphereRadiusMm) {
  LabelMap labels;
  labels.size = ct.size;
  labels.worldFromIndex = ct.worldFromIndex;
  labels.voxels.resize(ct.voxels.size());
  const double reach = sphereRadiusMm + 3;
  forEachChunk(static_cast<std::size_t>(ct.size.z()), 1, [&](std::size_t begin, std::size_t end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
      for (int j = 0; j < ct.size.y(); ++j)
        for (int i = 0; i < ct.size.x(); ++i) {
          if (ct.at(i, j, k) < phantom::kSiliconeLevel) continue;
          const Vector3d p = ct.world(Vector3d(i, j, k));
          const bool teflon = std::any_of(spheres.begin(), spheres.end(), [&](const Vector3d& centre) {
            return (p - centre).squaredNorm() < reach * reach;
          });
          labels.at(i, j, k) =
              static_cast<std::uint16_t>(teflon ? phantom::kTeflonLabel : phantom::kSiliconeLabel);
        }
  });
  return labels;
}

}  // namespace falciform
