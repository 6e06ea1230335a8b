#pragma once
#include "Logic/Core/Surface.h"

namespace falciform::test {

/// Icosphere of 10 * 4^subdivisions + 2 points, centred, closed, outwards.
[[nodiscard]] Surface sphere(double radiusMm, int subdivisions, const Vector3d& centre = Vector3d::Zero());
/// Closed box of 8 points and 12 triangles with corners 0 and `size`.
[[nodiscard]] Surface box(const Vector3d& size);
/// Open square grid in z = 0 from 0 to `sizeMm`, cells x cells squares cut alternately.
[[nodiscard]] Surface grid(double sizeMm, int cells);
/// Torus about z, closed.
[[nodiscard]] Surface torus(double ringRadiusMm, double tubeRadiusMm, int ringSegments, int tubeSegments);
/// A bumpy, asymmetric closed body of about 10 * 4^subdivisions points with patches 1 and 2 painted: for
/// registration tests.
[[nodiscard]] Surface lumpyBody(int subdivisions = 5);
/// A rigid motion drawn from `seed`: rotation uniform on SO(3), translation uniform in a cube of half edge
/// `translationMm`.
[[nodiscard]] Isometry3d randomMotion(unsigned seed, double translationMm = 100);

}  // namespace falciform::test
