#include "Testing/Verification/SharedProblems.h"

#include "Testing/Verification/Cantilever.h"
#include "Testing/Verification/PackedBlock.h"
#include "Testing/Verification/SlidingBed.h"
#include "Testing/Verification/ThickSphere.h"

namespace falciform::verification {
namespace {

/// The packed block with a stiff, heavy region in the middle, packed and weighed at once, turned in space.
HeldBody packedWithTumour(bool quadratic, int refinement, const Vector3d& gravity) {
  HeldBody block = packedBlock(0.47, quadratic, 25.0 / refinement, BlockLoad::Packed);
  block.materials.push_back({.youngsModulusMPa = 0.06, .poissonsRatio = 0.45, .densityKgPerM3 = 1200});
  for (Index e = 0; e < block.mesh.size(); ++e) {
    const Vector3d corner = block.mesh.points.row(block.mesh.elements(e, 0)).transpose();
    block.mesh.regions.push_back((corner - Vector3d(100, 75, 40)).norm() < 35 ? 1 : 0);
  }
  const Matrix3d rotation = someRotation();
  block.mesh.points = block.mesh.points * rotation.transpose();
  for (NodeConstraint& constraint : block.constraints) constraint.frame *= rotation.transpose();
  block.forces = weightForces(block.mesh, block.materials, gravity);
  return block;
}

}  // namespace

std::vector<SharedProblem> sharedProblems(bool quadratic, int refinement) {
  std::vector<SharedProblem> problems;
  const Vector3d down(0, 0, -9.81), oblique(3, -2, -9);
  problems.push_back({.name = "cantilever, own weight",
                      .body = cantilever(0.3, quadratic, refinement, CantileverLoad::OwnWeight),
                      .gravityMPerS2 = down});
  problems.push_back({.name = "cantilever, end shear",
                      .body = cantilever(0.3, quadratic, refinement, CantileverLoad::EndShear),
                      .asNodalForces = true});
  HeldBody sphere = thickSphere(Material{}, quadratic, 3 * refinement);
  std::vector<int> pressed = innerFaces(sphere.mesh, boundaryFaces(sphere.mesh));
  problems.push_back({.name = "thick sphere under pressure",
                      .body = std::move(sphere),
                      .pressedFaces = std::move(pressed),
                      .pressureMPa = kSpherePressureMPa});
  problems.push_back({.name = "curved sliding bed, tilted",
                      .body = slidingBed(quadratic, true, someRotation(), {100, -50, 30}).body,
                      .gravityMPerS2 = someRotation() * oblique});
  problems.push_back({.name = "packed block with a stiff region, tilted",
                      .body = packedWithTumour(quadratic, refinement, oblique),
                      .gravityMPerS2 = oblique});
  return problems;
}

}  // namespace falciform::verification
