#include "Testing/Verification/ThickSphere.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Biomechanics/FaceLoads.h"
#include "Logic/Biomechanics/QuadraticMesh.h"

namespace falciform::verification {
namespace {

constexpr double kInner = 20, kOuter = 40;  // mm

/// Columns of nodes, one for each place of a triangle (100, 010, 001) cut into n^2, pushed out to the sphere.
struct Columns {
  int n;
  [[nodiscard]] int at(int i, int j) const { return i * (n + 1) - i * (i - 1) / 2 + j; }
  [[nodiscard]] int count() const { return at(n, 0) + 1; }
};

/// The three tetrahedra of a prism; walls are cut from the lower column number's foot, so that neighbours
/// agree.
void addPrism(std::vector<std::array<int, 4>>& elements, std::array<int, 3> column, int layer, int perLayer) {
  std::sort(column.begin(), column.end());
  const int foot = layer * perLayer, top = foot + perLayer;
  const auto [a, b, c] = column;
  elements.push_back({foot + a, foot + b, foot + c, top + c});
  elements.push_back({foot + a, foot + b, top + b, top + c});
  elements.push_back({foot + a, top + a, top + b, top + c});
}

TetrahedralMesh octant(int n) {
  const Columns columns{n};
  TetrahedralMesh mesh;
  mesh.points.resize((n + 1) * columns.count(), 3);
  for (int layer = 0; layer <= n; ++layer)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        mesh.points.row(layer * columns.count() + columns.at(i, j)) =
            (kInner + (kOuter - kInner) * layer / n) * Vector3d(i, j, n - i - j).normalized().transpose();
  std::vector<std::array<int, 4>> elements;
  for (int layer = 0; layer < n; ++layer)
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        addPrism(elements, {columns.at(i, j), columns.at(i + 1, j), columns.at(i, j + 1)}, layer,
                 columns.count());
        if (i + j + 1 < n)
          addPrism(elements, {columns.at(i + 1, j), columns.at(i + 1, j + 1), columns.at(i, j + 1)}, layer,
                   columns.count());
      }
  mesh.elements.resize(static_cast<Index>(elements.size()), 4);
  for (Index e = 0; e < mesh.size(); ++e) {
    for (std::size_t k = 0; k < 4; ++k)
      mesh.elements(e, static_cast<Index>(k)) = elements[static_cast<std::size_t>(e)][k];
    if (cornerVolume(mesh, e) < 0) std::swap(mesh.elements(e, 2), mesh.elements(e, 3));
  }
  return mesh;
}

}  // namespace

std::vector<int> innerFaces(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  return facesWhere(mesh, faces, [](const Vector3d& x) { return x.norm() < kInner + 1e-9; });
}

HeldBody thickSphere(const Material& material, bool quadratic, int layers) {
  const TetrahedralMesh linear = octant(layers);
  const TetrahedralMesh mesh = quadratic ? quadraticMesh(linear) : linear;
  const BoundaryFaces faces = boundaryFaces(mesh);
  std::vector<Support> cuts;
  for (int axis = 0; axis < 3; ++axis)
    cuts.push_back({.name = "cut",
                    .kind = SupportKind::Sliding,
                    .faces = facesWhere(mesh, faces, [&](const Vector3d& x) { return x[axis] < 1e-9; })});
  HeldBody sphere = heldBody(mesh, material, cuts);
  sphere.forces = pressureForces(mesh, faces, innerFaces(mesh, faces), kSpherePressureMPa);
  return sphere;
}

double lameDisplacementMm(const Material& material, double r) {
  const double a3 = std::pow(kInner, 3), b3 = std::pow(kOuter, 3), nu = material.poissonsRatio;
  return kSpherePressureMPa * a3 / (material.youngsModulusMPa * (b3 - a3)) *
         ((1 - 2 * nu) * r + (1 + nu) * b3 / (2 * r * r));
}

SphereErrors sphereErrors(const HeldBody& sphere, const Points& displacements) {
  const Material& material = sphere.materials.front();
  double worst = 0;
  for (Index n = 0; n < sphere.mesh.nodes(); ++n) {
    const Vector3d x = sphere.mesh.points.row(n).transpose();
    const Vector3d expected = lameDisplacementMm(material, x.norm()) * x.normalized();
    worst = std::max(worst, (displacements.row(n).transpose() - expected).norm());
  }
  const double swell = sphere.forces.cwiseProduct(displacements).sum() / kSpherePressureMPa;
  const double expected = EIGEN_PI / 2 * kInner * kInner * lameDisplacementMm(material, kInner);
  return {.worst = worst / lameDisplacementMm(material, kInner), .swell = swell / expected - 1};
}

}  // namespace falciform::verification
