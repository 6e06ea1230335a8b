#include "Testing/Verification/SlidingBed.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::verification {

SlidingBed slidingBed(bool quadratic, bool wavy, const Matrix3d& rotation, const Vector3d& translation) {
  const Vector3d size(60, 40, 30);
  TetrahedralMesh linear = test::shakenBlockMesh(size, {6, 4, 3}, 0.2, 5);
  const BoundaryFaces flat = boundaryFaces(linear);
  const auto bottom = facesWhere(linear, flat, [](const Vector3d& x) { return x[2] < 1e-9; });
  const auto end = facesWhere(linear, flat, [](const Vector3d& x) { return x[0] < 1e-9; });
  for (Index n = 0; n < linear.nodes(); ++n) {
    Vector3d x = linear.points.row(n).transpose();
    if (wavy) x[2] += (1 - x[2] / size[2]) * 3 * std::sin(x[0] / 12) * std::cos(x[1] / 9);
    linear.points.row(n) = (rotation * x + translation).transpose();
  }
  const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;  // faces keep their numbers
  SlidingBed problem{.body = heldBody(mesh, Material{},
                                      {{.name = "end", .faces = end},
                                       {.name = "bed", .kind = SupportKind::Sliding, .faces = bottom}}),
                     .bed = {}};
  problem.body.forces = weightForces(mesh, problem.body.materials, rotation * Vector3d(3, -2, -9));
  for (const NodeConstraint& constraint : problem.body.constraints)
    if (constraint.count == 1) problem.bed.push_back(constraint);
  return problem;
}

Matrix3d someRotation() {
  return Eigen::AngleAxisd(1.234, Vector3d(0.3, -0.7, 0.5).normalized()).toRotationMatrix();
}

BedErrors bedErrors(bool quadratic, bool wavy) {
  const SlidingBed level = slidingBed(quadratic, wavy, Matrix3d::Identity(), Vector3d::Zero());
  const SlidingBed tilted = slidingBed(quadratic, wavy, someRotation(), {100, -50, 30});
  const Points expected = solve(level.body).displacements * someRotation().transpose();
  const BodyAnswer answer = solve(tilted.body);
  const double weight = tilted.body.forces.colwise().sum().norm(), span = largest(expected);
  BedErrors errors{.rotated = largest(answer.displacements - expected) / span};
  for (const NodeConstraint& at : tilted.bed) {
    const Vector3d normal = at.frame.row(0).transpose(), u = answer.displacements.row(at.node).transpose(),
                   force = answer.reactions.row(at.node).transpose();
    errors.intoBed = std::max(errors.intoBed, std::abs(u.dot(normal)) / span);
    errors.tangentialForce =
        std::max(errors.tangentialForce, (force - force.dot(normal) * normal).norm() / weight);
  }
  errors.balance = (answer.reactions + tilted.body.forces).colwise().sum().norm() / weight;
  return errors;
}

}  // namespace falciform::verification
