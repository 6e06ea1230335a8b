#include "Testing/Verification/NeoHookeanBar.h"

#include <cmath>
#include <functional>

#include "Logic/Biomechanics/FaceLoads.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::verification {
namespace {

/// Where a rising function is 0.
double rootOf(const std::function<double(double)>& rising, double low, double high) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (rising(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Cauchy stresses along and across for a stretch `along` and twice `across`.
struct Stresses {
  double along = 0, across = 0;
};
Stresses stresses(const Material& m, double along, double across) {
  const double bulk = m.youngsModulusMPa / (3 * (1 - 2 * m.poissonsRatio));
  const double volume = along * across * across, trace = along * along + 2 * across * across;
  const double shear = shearModulusMPa(m) * std::pow(volume, -5.0 / 3), pressure = bulk * (volume - 1);
  return {shear * (along * along - trace / 3) + pressure, shear * (across * across - trace / 3) + pressure};
}

/// The stretch across that leaves the sides free.
double freeAcross(const Material& m, double along) {
  return rootOf([&](double across) { return stresses(m, along, across).across; }, 0.1, 3);
}

/// Stress by undeformed area.
double nominal(const Material& m, double along, double across) {
  return stresses(m, along, across).along * across * across;
}

double confinedStretch(const Material& m, double gravity, double x) {
  const double above = m.densityKgPerM3 * 1e-9 * gravity * (kBarLengthMm - x);  // N/mm2
  return rootOf([&](double along) { return nominal(m, along, 1) + above; }, 0.05, 3);
}

}  // namespace

SharedProblem neoHookeanBar(const Material& material, BarLoad kind, double load, int layers) {
  const TetrahedralMesh mesh =
      quadraticMesh(test::blockMesh({kBarLengthMm, kBarWidthMm, kBarWidthMm}, {layers, 2, 2}));
  const BoundaryFaces faces = boundaryFaces(mesh);
  std::vector<Support> planes;
  for (int axis = 0; axis < 3; ++axis) {
    planes.push_back({.name = "plane",
                      .kind = SupportKind::Sliding,
                      .faces = facesWhere(mesh, faces, [&](const Vector3d& p) { return p[axis] < 1e-9; })});
    if (kind == BarLoad::OwnWeightConfined && axis > 0)
      planes.push_back({.name = "far plane",
                        .kind = SupportKind::Sliding,
                        .faces = facesWhere(
                            mesh, faces, [&](const Vector3d& p) { return p[axis] > kBarWidthMm - 1e-9; })});
  }
  SharedProblem problem{.name = "neo-Hookean bar", .body = heldBody(mesh, material, planes)};
  problem.neoHookean = true;
  if (kind == BarLoad::OwnWeightConfined) {
    problem.gravityMPerS2 = {-load, 0, 0};
    return problem;
  }
  problem.asNodalForces = true;
  problem.body.forces = tractionForces(
      mesh, faces, facesWhere(mesh, faces, [](const Vector3d& p) { return p.x() > kBarLengthMm - 1e-9; }),
      {load, 0, 0});
  return problem;
}

BarMotion neoHookeanBarMotion(const Material& m, BarLoad kind, double load, double x) {
  if (kind == BarLoad::EndTraction) {
    const double along = rootOf([&](double s) { return nominal(m, s, freeAcross(m, s)) - load; }, 0.2, 4);
    return {.alongMm = (along - 1) * x, .widening = freeAcross(m, along) - 1};
  }
  constexpr int kPanels = 200;  // Simpson's rule: smooth, so 1e-9 of the whole is not in question
  double sum = 0;
  for (int i = 0; i <= kPanels; ++i) {
    const double weight = i == 0 || i == kPanels ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * (confinedStretch(m, load, x * i / kPanels) - 1);
  }
  return {.alongMm = sum * x / kPanels / 3, .widening = 0};
}

}  // namespace falciform::verification
