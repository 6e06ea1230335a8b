#include "Testing/Verification/SmoothField.h"

#include <cmath>

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Verification/TetrahedronQuadrature.h"

namespace falciform::verification {
namespace {

Vector3d placeIn(const TetrahedralMesh& mesh, Index e, const Eigen::Vector4d& barycentric) {
  Vector3d x = Vector3d::Zero();
  for (int k = 0; k < 4; ++k) x += barycentric[k] * mesh.points.row(mesh.elements(e, k)).transpose();
  return x;
}

double energyDensity(const Matrix3d& gradient, const Material& material) {
  const Matrix3d strain = (gradient + gradient.transpose()) / 2;
  return lameLambdaMPa(material) * strain.trace() * strain.trace() / 2 +
         shearModulusMPa(material) * strain.squaredNorm();
}

}  // namespace

Vector3d SmoothField::displacement(const Vector3d& x) const {
  Vector3d sum = Vector3d::Zero();
  for (const Wave& w : waves) sum += std::sin(w.number.dot(x) + w.phase) * w.amplitude;
  return sum;
}

Matrix3d SmoothField::gradient(const Vector3d& x) const {
  Matrix3d sum = Matrix3d::Zero();
  for (const Wave& w : waves) sum += std::cos(w.number.dot(x) + w.phase) * w.amplitude * w.number.transpose();
  return sum;
}

Vector3d SmoothField::bodyForce(const Vector3d& x) const {
  const double lambda = lameLambdaMPa(material), mu = shearModulusMPa(material);
  Vector3d sum = Vector3d::Zero();
  for (const Wave& w : waves)
    sum += std::sin(w.number.dot(x) + w.phase) *
           ((lambda + mu) * w.number.dot(w.amplitude) * w.number + mu * w.number.squaredNorm() * w.amplitude);
  return sum;
}

SmoothField smoothField(const Material& material) {
  return {.waves = {{{.amplitude = {1, 0.3, -0.2}, .number = {0.10, 0.04, -0.02}, .phase = 0.4},
                     {.amplitude = {-0.3, 0.8, 0.4}, .number = {-0.03, 0.11, 0.05}, .phase = 1.1},
                     {.amplitude = {0.2, -0.5, 0.9}, .number = {0.06, -0.05, 0.09}, .phase = 2.3}}},
          .material = material};
}

HeldBody bodyUnder(const SmoothField& field, const TetrahedralMesh& mesh) {
  const BoundaryFaces faces = boundaryFaces(mesh);
  const NodeNormals normals = nodeNormals(faces, mesh.nodes());
  HeldBody body{.mesh = mesh,
                .materials = {field.material},
                .constraints = {},
                .forces = Points::Zero(mesh.nodes(), 3)};
  for (Index n = 0; n < mesh.nodes(); ++n)
    if (normals.normals.row(n).squaredNorm() > 0)
      body.constraints.push_back({.node = static_cast<int>(n),
                                  .count = 3,
                                  .frame = Matrix3d::Identity(),
                                  .valuesMm = field.displacement(mesh.points.row(n).transpose())});
  const int nodes = static_cast<int>(mesh.elements.cols());
  for (const QuadraturePlace& place : finePlaces()) {
    const VectorXd shape = shapeValues(place.barycentric, nodes);
    for (Index e = 0; e < mesh.size(); ++e) {
      const Vector3d force =
          place.weight * cornerVolume(mesh, e) * field.bodyForce(placeIn(mesh, e, place.barycentric));
      for (int k = 0; k < nodes; ++k) body.forces.row(mesh.elements(e, k)) += shape[k] * force.transpose();
    }
  }
  return body;
}

FieldError errorOf(const Points& displacements, const SmoothField& field, const TetrahedralMesh& mesh) {
  const int nodes = static_cast<int>(mesh.elements.cols());
  double difference = 0, whole = 0, energyDifference = 0, energyWhole = 0;
  for (Index e = 0; e < mesh.size(); ++e) {
    const auto barycentric = barycentricGradients(mesh, e);
    const Eigen::Matrix<double, Eigen::Dynamic, 3> u =
        displacements(Eigen::VectorXi(mesh.elements.row(e).transpose()), Eigen::all);
    for (const QuadraturePlace& place : finePlaces()) {
      const double volume = place.weight * cornerVolume(mesh, e);
      const Vector3d x = placeIn(mesh, e, place.barycentric);
      const Vector3d there = u.transpose() * shapeValues(place.barycentric, nodes);
      const Matrix3d gradient = u.transpose() * shapeGradients(place.barycentric, barycentric, nodes);
      difference += volume * (there - field.displacement(x)).squaredNorm();
      whole += volume * field.displacement(x).squaredNorm();
      energyDifference += volume * energyDensity(gradient - field.gradient(x), field.material);
      energyWhole += volume * energyDensity(field.gradient(x), field.material);
    }
  }
  return {.displacement = std::sqrt(difference / whole), .energy = std::sqrt(energyDifference / energyWhole)};
}

FieldError smoothFieldError(const Material& material, bool quadratic, int cells) {
  const SmoothField field = smoothField(material);
  const TetrahedralMesh linear =
      test::shakenBlockMesh(Vector3d::Constant(30), Vector3i::Constant(cells), 0.15, 11);
  const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
  return errorOf(solve(bodyUnder(field, mesh)).displacements, field, mesh);
}

double observedOrder(double coarseError, double fineError, int coarse, int fine) {
  return std::log(coarseError / fineError) / std::log(static_cast<double>(fine) / coarse);
}

}  // namespace falciform::verification
