#pragma once
#include <random>

#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

/// The part of `body` (star-shaped about the origin) within `halfAngleDeg` of direction `from`, every
/// `stride`-th point, as a cloud with labels, moved by `scanFromPreop`, with Gaussian noise of `noiseMm` on
/// each coordinate.
inline Surface partialScan(const Surface& body, const Vector3d& from, double halfAngleDeg, int stride,
                           const Isometry3d& scanFromPreop, double noiseMm = 0, unsigned seed = 1) {
  std::vector<int> keep;
  for (Index i = 0; i < body.size(); i += stride)
    if (body.points.row(i).normalized().dot(from.normalized()) > std::cos(halfAngleDeg * EIGEN_PI / 180))
      keep.push_back(static_cast<int>(i));
  Surface scan;
  scan.points.resize(static_cast<Index>(keep.size()), 3);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, noiseMm > 0 ? noiseMm : 1);
  for (std::size_t k = 0; k < keep.size(); ++k) {
    Vector3d p = scanFromPreop * body.points.row(keep[k]).transpose();
    if (noiseMm > 0) p += Vector3d(noise(random), noise(random), noise(random));
    scan.points.row(static_cast<Index>(k)) = p.transpose();
    scan.patch.push_back(body.patchAt(keep[k]));
  }
  scan.frame = "scanner";
  return scan;
}

/// Largest distance by which two poses place a point of `points` apart, mm.
inline double placedApart(const Points& points, const Isometry3d& a, const Isometry3d& b) {
  return (transformed(points, a) - transformed(points, b)).rowwise().norm().maxCoeff();
}

}  // namespace falciform::test
