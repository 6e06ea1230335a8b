#pragma once
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {

/// An octant of a thick sphere, 20 to 40 mm, under 0.1 kPa from inside, its three cuts sliding: `layers`
/// through the thickness and along each edge. Faces are plane, so that the body is a polyhedron inside the
/// sphere.
[[nodiscard]] HeldBody thickSphere(const Material& material, bool quadratic, int layers);

/// Boundary faces of the inner surface.
[[nodiscard]] std::vector<int> innerFaces(const TetrahedralMesh& mesh, const BoundaryFaces& faces);

inline constexpr double kSpherePressureMPa = 1e-4;

/// Lame's displacement along the radius at a place r from the centre, mm:
/// p a^3 / (E (b^3 - a^3)) ((1 - 2 nu) r + (1 + nu) b^3 / (2 r^2)).
[[nodiscard]] double lameDisplacementMm(const Material& material, double r);

/// How far an answer is from Lame's.
struct SphereErrors {
  double worst = 0;  ///< the largest difference over all nodes, by the largest displacement
  double swell = 0;  ///< of the volume by which the hollow grows, relative; below 0: too stiff
};
[[nodiscard]] SphereErrors sphereErrors(const HeldBody& sphere, const Points& displacements);

}  // namespace falciform::verification
