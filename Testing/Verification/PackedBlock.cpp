#include "Testing/Verification/PackedBlock.h"

#include <cmath>

#include "Logic/Biomechanics/FaceLoads.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::verification {
namespace {

const Vector3d kSize(200, 150, 80);  // mm
constexpr double kPushMm = 10;

}  // namespace

HeldBody packedBlock(double poissonsRatio, bool quadratic, double boxMm, BlockLoad load) {
  // Along z a box is four fifths as long: 80 mm are no whole number of 25.
  const auto count = [&](double mm) { return static_cast<int>(std::lround(mm / boxMm)); };
  const TetrahedralMesh linear = test::blockMesh(kSize, {count(200), count(150), count(100)});
  const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
  const BoundaryFaces faces = boundaryFaces(mesh);
  std::vector<Support> supports{
      {.name = "end", .faces = facesWhere(mesh, faces, [](const Vector3d& x) { return x[0] < 1e-9; })}};
  if (load == BlockLoad::Packed)
    supports.push_back({.name = "pack",
                        .kind = SupportKind::Pushed,
                        .faces = facesWhere(mesh, faces,
                                            [](const Vector3d& x) {
                                              return x[2] < 1e-9 && x[0] > 150 - 1e-9 && x[1] > 50 - 1e-9 &&
                                                     x[1] < 100 + 1e-9;
                                            }),
                        .pushMm = kPushMm});
  HeldBody block = heldBody(mesh, {.youngsModulusMPa = 0.015, .poissonsRatio = poissonsRatio}, supports);
  if (load == BlockLoad::OwnWeight) block.forces = weightForces(mesh, block.materials, {0, 0, -9.81});
  return block;
}

double blockStiffness(const HeldBody& block, BlockLoad load) {
  const BodyAnswer answer = solve(block);
  const Points& points = block.mesh.points;
  if (load == BlockLoad::Packed) {
    double force = 0;
    for (Index n = 0; n < points.rows(); ++n)
      if (points(n, 0) > 1e-9) force += answer.reactions(n, 2);  // not of the fixed end
    return force / kPushMm;
  }
  const BoundaryFaces faces = boundaryFaces(block.mesh);
  const auto end = facesWhere(block.mesh, faces, [](const Vector3d& x) { return x[0] > kSize[0] - 1e-9; });
  const Points shares = tractionForces(block.mesh, faces, end, {0, 0, 1 / (kSize[1] * kSize[2])});
  return block.forces.col(2).sum() / shares.col(2).dot(answer.displacements.col(2));
}

}  // namespace falciform::verification
