#include "Testing/Logic/Atlas/BeanLiver.h"

#include <cmath>
#include <numbers>

#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Atlas/UpdatedPlaces.h"
#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Biomechanics/StiffnessMatrix.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Subdivision.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

constexpr int kPlaces = 6, kAmounts = 5;
constexpr double kStepMm = 1.5;

/// Height of the flat side.
double underside(double x) { return 0.0012 * (x - 40) * (x - 40); }

/// Displacements of 1 mm RMS, one for each place of the underside.
std::vector<Points> pressedFields(const TetrahedralMesh& mesh, const VectorXd& volumes) {
  const LoadResponses loads = solveSurfaceLoads(mesh, {Material{}}, {.centres = 30, .radiusMm = 18});
  std::vector<Points> fields;
  for (Index c = 0; c < loads.centres.rows() && fields.size() < kPlaces; ++c) {
    if (loads.centres(c, 2) > underside(loads.centres(c, 0)) + 1) continue;
    Points field(mesh.nodes(), 3);
    Eigen::Map<VectorXd>(field.data(), field.size()) =
        loads.responses.row(3 * c + 2).transpose().cast<double>();
    field /= std::sqrt(volumes.dot(field.rowwise().squaredNorm()) / volumes.sum());
    fields.push_back(field);
  }
  return fields;
}

}  // namespace

TetrahedralMesh beanMesh() {
  TetrahedralMesh mesh = blockMesh({120, 80, 50}, {12, 8, 5});
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const double u = mesh.points(n, 0) / 120, v = mesh.points(n, 1) / 80, share = mesh.points(n, 2) / 50;
    const double dome =
        std::sin(std::numbers::pi * (0.1 + 0.8 * u)) * std::sin(std::numbers::pi * (0.15 + 0.7 * v));
    mesh.points(n, 1) = 40 + 80 * (v - 0.5) * (1 - 0.35 * u * u) + 8 * std::sin(120 * u / 25);
    mesh.points(n, 2) = underside(120 * u) + share * (12 + 60 * (1 - 0.55 * u) * dome);
  }
  return quadraticMesh(mesh);
}

const Surface& beanSurface() {
  static const Surface made = [] {
    const TetrahedralMesh mesh = beanMesh();
    Surface surface = boundarySurface(mesh, boundaryFaces(mesh)).surface;
    surface.patch.assign(static_cast<std::size_t>(surface.size()), 0);
    for (Index i = 0; i < surface.size(); ++i) {
      const double x = surface.points(i, 0), y = surface.points(i, 1);
      if (std::abs(x - 60) < 12) surface.patch[static_cast<std::size_t>(i)] = 1;
      if (y - 8 * std::sin(x / 25) < 12) surface.patch[static_cast<std::size_t>(i)] = 2;
    }
    return surface;
  }();
  return made;
}

const Atlas& beanAtlas() {
  static const Atlas made = [] {
    Atlas atlas;
    atlas.mesh = beanMesh();
    atlas.nodeVolumesMm3 = nodalVolumes(atlas.mesh);
    const std::vector<Points> fields = pressedFields(atlas.mesh, atlas.nodeVolumesMm3);
    Eigen::MatrixXd combinations = Eigen::MatrixXd::Zero(kPlaces * kAmounts, kPlaces);
    for (Index m = 0; m < combinations.rows(); ++m)
      combinations(m, m / kAmounts) = kStepMm * static_cast<double>(1 + m % kAmounts);
    CompressedFields compressed = compressFields(fields, combinations, atlas.nodeVolumesMm3, 1);
    atlas.modes = std::move(compressed.modes);
    atlas.coefficients = std::move(compressed.coefficients);
    atlas.singularValuesMm = std::move(compressed.singularValuesMm);
    const StiffnessMatrix stiffness = assembleStiffness(atlas.mesh, materialsOf(atlas.design));
    atlas.stiffness.resize(atlas.rank(), atlas.rank());
    for (Index k = 0; k < atlas.rank(); ++k) {
      const Points forces = stiffness.times(atlas.modes[static_cast<std::size_t>(k)]);
      for (Index i = 0; i < atlas.rank(); ++i)
        atlas.stiffness(i, k) = atlas.modes[static_cast<std::size_t>(i)].cwiseProduct(forces).sum();
    }
    return atlas;
  }();
  return made;
}

BeanTruth beanTruth(const std::vector<double>& amounts, double noiseMm) {
  const Atlas& atlas = beanAtlas();
  Points displacements = Points::Zero(atlas.mesh.nodes(), 3);
  for (std::size_t place = 0; place < amounts.size(); ++place)
    displacements +=
        amounts[place] / kStepMm * memberDisplacements(atlas, kAmounts * static_cast<Index>(place));
  return beanMoved(displacements, noiseMm);
}

BeanTruth beanMoved(const Points& displacements, double noiseMm) {
  const TetrahedralMesh mesh = beanMesh();
  BeanTruth truth;
  UpdateResult moved;
  moved.scanFromPreop = truth.scanFromPreop = randomMotion(5);
  moved.displacements = displacements;
  truth.displacements = moved.displacements;
  std::vector<int> inside;
  for (Index n = 0; n < mesh.nodes(); n += 7) inside.push_back(static_cast<int>(n));
  truth.before = mesh.points(inside, Eigen::all);
  truth.after = scanFromPreop(mesh, moved, truth.before);
  const Surface fine = subdividedTo(beanSurface(), 2.5);
  const Points normals = vertexNormals(fine);
  std::vector<int> seen;
  for (Index i = 0; i < fine.size(); ++i)
    if (normals(i, 2) > 0.3) seen.push_back(static_cast<int>(i));
  truth.scan.points = scanFromPreop(mesh, moved, fine.points(seen, Eigen::all));
  Draws draws(11);
  for (Index i = 0; i < truth.scan.size(); ++i) {
    truth.scan.points.row(i) += noiseMm * draws.normal3().transpose();
    truth.scan.patch.push_back(fine.patchAt(seen[static_cast<std::size_t>(i)]));
  }
  truth.scan.frame = "scanner";
  return truth;
}

double meanError(const TetrahedralMesh& mesh, const UpdateResult& update, const BeanTruth& truth) {
  return (scanFromPreop(mesh, update, truth.before) - truth.after).rowwise().norm().mean();
}

}  // namespace falciform::test
