#include "Testing/Verification/Cantilever.h"

#include "Logic/Biomechanics/FaceLoads.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::verification {
namespace {

constexpr double kLength = 100, kDepth = 10;  // mm
constexpr double kShearMPa = 1e-6;            // on the free end
constexpr double kGravity = 9.81;             // m/s2

Material barOf(double poissonsRatio) {
  return {.youngsModulusMPa = 0.015, .poissonsRatio = poissonsRatio, .densityKgPerM3 = 1000};
}

std::vector<int> freeEnd(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  return facesWhere(mesh, faces, [](const Vector3d& x) { return x[0] > kLength - 1e-9; });
}

}  // namespace

HeldBody cantilever(double poissonsRatio, bool quadratic, int cells, CantileverLoad load) {
  const TetrahedralMesh linear =
      test::blockMesh({kLength, kDepth, kDepth}, {cells * static_cast<int>(kLength / kDepth), cells, cells});
  const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
  const BoundaryFaces faces = boundaryFaces(mesh);
  HeldBody bar = heldBody(
      mesh, barOf(poissonsRatio),
      {{.name = "clamp", .faces = facesWhere(mesh, faces, [](const Vector3d& x) { return x[0] < 1e-9; })}});
  if (load == CantileverLoad::OwnWeight)
    bar.forces = weightForces(mesh, bar.materials, {0, 0, -kGravity});
  else
    bar.forces = tractionForces(mesh, faces, freeEnd(mesh, faces), {0, 0, -kShearMPa});
  return bar;
}

double endSagMm(const HeldBody& bar, const Points& displacements) {
  const BoundaryFaces faces = boundaryFaces(bar.mesh);
  // Unit traction weighs each node with its share of the face.
  const Points shares = tractionForces(bar.mesh, faces, freeEnd(bar.mesh, faces), {0, 0, 1});
  return -shares.col(2).dot(displacements.col(2)) / (kDepth * kDepth);
}

double timoshenkoSagMm(double nu, CantileverLoad load) {
  const Material bar = barOf(nu);
  const double area = kDepth * kDepth, inertia = area * kDepth * kDepth / 12;
  const double bending = bar.youngsModulusMPa * inertia;
  const double shear = 10 * (1 + nu) / (12 + 11 * nu) * shearModulusMPa(bar) * area;
  if (load == CantileverLoad::OwnWeight) {
    const double weight = bodyForce(bar, {0, 0, kGravity})[2] * area;  // N/mm
    return weight * kLength * kLength * (kLength * kLength / (8 * bending) + 1 / (2 * shear));
  }
  return kShearMPa * area * kLength * (kLength * kLength / (3 * bending) + 1 / shear);
}

}  // namespace falciform::verification
