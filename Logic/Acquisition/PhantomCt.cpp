#include "Logic/Acquisition/PhantomCt.h"

#include <algorithm>
#include <cmath>

#include "Logic/Acquisition/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {
namespace {

constexpr int kParts = 3;  // of a voxel at a border, each way

/// Share of a cube of edge `h` below the zero of a distance `d` at its middle, for planes of a mean tilt:
/// over all directions the cube is 1.5 h thick across the plane.
double shareInside(double d, double h) { return std::clamp(0.5 - d / (1.5 * h), 0.0, 1.0); }

double distanceToSpheres(const PhantomBody& body, const Vector3d& p) {
  double nearest = 1e9;
  for (const Vector3d& centre : body.spheres) nearest = std::min(nearest, (p - centre).norm());
  return nearest - body.sphereRadiusMm;
}

/// Mean of `share` over kParts^3 parts of the voxel at `middle`.
template <class Distance>
double meanShare(const Distance& distance, const Vector3d& middle, double voxelMm) {
  const double part = voxelMm / kParts;
  double sum = 0;
  for (int n = 0; n < kParts * kParts * kParts; ++n) {
    const Vector3d at(n % kParts, n / kParts % kParts, n / (kParts * kParts));
    sum += shareInside(distance(middle + part * (at.array() - 0.5 * (kParts - 1)).matrix()), part);
  }
  return sum / (kParts * kParts * kParts);
}

/// Share of a voxel in a body, sampled finely only where its border may cross: the distance, a bound of which
/// is its slope of 2, is known at the middle.
template <class Distance>
double voxelShare(const Distance& distance, double atMiddle, const Vector3d& middle, double voxelMm) {
  if (std::abs(atMiddle) > 2 * voxelMm) return atMiddle < 0 ? 1 : 0;
  return meanShare(distance, middle, voxelMm);
}

}  // namespace

Image imagePhantom(const PhantomBody& body, double voxelMm, double noiseHu, int seed,
                   const Progress& progress) {
  const auto liver = [&](const Vector3d& p) { return body.liver.distance(p); };
  const auto spheres = [&](const Vector3d& p) { return distanceToSpheres(body, p); };
  Image ct = sampleDepth(liver, body.bounds(), voxelMm, progress.part(0, 0.3));  // depth first, then HU
  const auto rows = static_cast<std::size_t>(ct.size.y());
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
          const double hu = phantom::kAirHu + silicone * (phantom::kSiliconeHu - phantom::kAirHu) +
                            teflon * (phantom::kTeflonHu - phantom::kAirHu);
          value = static_cast<float>(std::round(hu + noiseHu * draws.normal()));
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
