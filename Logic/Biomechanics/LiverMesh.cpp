#include "Logic/Biomechanics/LiverMesh.h"

#include <cmath>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/CrossingRepair.h"
#include "Logic/Biomechanics/MeshInput.h"
#include "Logic/Biomechanics/MeshQuality.h"
#include "Logic/Biomechanics/MeshTumours.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Core/PlaceText.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/SurfaceDistances.h"
#include "Logic/Geometry/Tetrahedra.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

constexpr double kPoorDihedralDeg = 3;  ///< below, an element is mended if possible

/// Of a regular tetrahedron with this edge, mm3.
double regularVolume(double edgeMm) { return edgeMm * edgeMm * edgeMm / (6 * std::sqrt(2.0)); }

[[noreturn]] void refuseCrossings(const std::vector<Crossing>& pairs, const std::string& what,
                                  const std::string& remedy) {
  const Crossing& first = pairs.front();
  throw InputError(what + " cuts through itself: " +
                   (pairs.size() == 1 ? std::string("a pair") : std::to_string(pairs.size()) + " pairs") +
                   " of triangles cross, the first " + std::to_string(first.first) + " and " +
                   std::to_string(first.second) + " at " + placeText(first.place) + "; " + remedy);
}

void checkSize(const Surface& surface, double edgeLengthMm) {
  const double volume = signedVolume(surface);
  if (volume < std::pow(edgeLengthMm, 3))
    throw InputError("the liver's surface encloses " + std::to_string(volume / 1000) +
                     " ml, too little for edges of " + std::to_string(edgeLengthMm) +
                     " mm; check that it is in mm, or choose shorter edges");
}

TetrahedralMesh filled(const Surface& surface, const std::vector<TumourPiece>& pieces,
                       const MeshSettings& settings) {
  TetrahedraPlan plan;
  plan.maxVolumeMm3 =
      settings.maxVolumeMm3 > 0 ? settings.maxVolumeMm3 : regularVolume(settings.edgeLengthMm);
  plan.radiusEdgeRatio = settings.radiusEdgeRatio;
  plan.minDihedralDeg = settings.minDihedralDeg;
  for (const TumourPiece& piece : pieces) {
    if (!piece.conforming) continue;
    plan.inner.push_back(piece.surface);
    plan.innerMaxVolumeMm3.push_back(std::min(regularVolume(piece.edgeMm), plan.maxVolumeMm3));
  }
  plan.extra = refiningPoints(pieces, surface);
  TetrahedralMesh mesh = tetrahedralise(surface, plan);
  mesh.frame = surface.frame;
  mesh.regions = regionsOf(mesh, pieces);
  return mesh;
}

/// Where TetGen can only make flat elements: between sheets that nearly touch.
std::vector<Vector3d> poorPlaces(const Surface& surface, const MeshSettings& settings) {
  const TetrahedralMesh mesh = filled(surface, {}, settings);
  std::vector<Vector3d> places;
  for (Index e = 0; e < mesh.size(); ++e) {
    if (shapeOf(mesh, e).minDihedralDeg >= kPoorDihedralDeg) continue;
    const auto corners = mesh.elements.row(e).head(4).transpose().eval();
    places.emplace_back(mesh.points(corners, Eigen::all).colwise().mean().transpose());
  }
  return places;
}

Surface readySurface(const Surface& closed, const MeshSettings& settings, MeshReport& report,
                     const Progress& progress) {
  const double maxRepair = settings.maxRepairMm > 0 ? settings.maxRepairMm : settings.edgeLengthMm / 2;
  MeshableSurface ready = meshableSurface(
      closed, settings.edgeLengthMm, maxRepair, [&](const Surface& s) { return poorPlaces(s, settings); },
      progress);
  report.crossingPairs = std::ssize(ready.first);
  report.repairs = ready.repairs;
  if (ready.left.empty()) return ready.surface;
  const std::string remedy =
      "mend it there, or allow a larger repair (--max-repair, now " + std::to_string(maxRepair) + " mm)";
  if (const auto own = selfCrossings(closed); !own.empty())
    refuseCrossings(own, "the liver's surface", remedy);
  refuseCrossings(ready.left,
                  "the liver's surface, remeshed to " + std::to_string(settings.edgeLengthMm) + " mm,",
                  remedy + ", or choose another edge length");
}

void measureRegions(const TetrahedralMesh& mesh, const std::vector<TumourPiece>& pieces, Index tumours,
                    MeshReport& report) {
  report.regions.resize(static_cast<std::size_t>(tumours) + 1);
  for (std::size_t k = 0; k < report.regions.size(); ++k) report.regions[k].number = static_cast<int>(k);
  for (const TumourPiece& piece : pieces) {
    MeshRegion& region = report.regions[static_cast<std::size_t>(piece.region)];
    region.wantedMm3 += signedVolume(piece.surface);
    region.conforming = region.conforming && piece.conforming;
  }
  for (Index e = 0; e < mesh.size(); ++e) {
    MeshRegion& region = report.regions[static_cast<std::size_t>(mesh.regionOf(e))];
    ++region.elements;
    region.volumeMm3 += cornerVolume(mesh, e);
  }
  for (const MeshRegion& region : report.regions)
    if (region.elements == 0 && region.number > 0)
      report.warnings.push_back("tumour " + std::to_string(region.number) +
                                " has no elements: none has its centre in it; choose shorter edges");
}

void measureBoundary(const TetrahedralMesh& mesh, const Surface& input, MeshReport& report) {
  const Surface boundary = boundarySurface(mesh, boundaryFaces(mesh)).surface;
  Points middles(boundary.triangles.rows(), 3);
  VectorXd areas(boundary.triangles.rows());
  for (Index t = 0; t < middles.rows(); ++t) {
    const Matrix3d corners = boundary.points(boundary.triangles.row(t).transpose().eval(), Eigen::all);
    middles.row(t) = corners.colwise().mean();
    areas[t] = (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).norm() / 2;
  }
  const VectorXd atMiddles = distancesTo(input, middles);
  report.meanDistanceMm = atMiddles.dot(areas) / areas.sum();
  report.maxDistanceMm = std::max(atMiddles.maxCoeff(), distancesTo(input, boundary.points).maxCoeff());
  report.maxUncoveredMm = distancesTo(boundary, input.points).maxCoeff();
}

}  // namespace

LiverMesh meshLiver(const Surface& preop, const std::vector<Surface>& tumours, const MeshSettings& settings,
                    const Progress& progress) {
  checkSettings(settings);
  LiverMesh result;
  MeshReport& report = result.report;
  const Surface input =
      closedSurface(preop, "the liver's surface",
                    settings.largestPiece ? Pieces::KeepLargest : Pieces::Refuse, report.warnings);
  checkSize(input, settings.edgeLengthMm);
  const Surface surface = readySurface(input, settings, report, progress.part(0, 0.5));
  progress.report(0.5, "Placing tumours");
  const std::vector<TumourPiece> pieces = tumourPieces(tumours, surface, settings, report.warnings);
  progress.report(0.6, "Filling with tetrahedra");
  TetrahedralMesh& mesh = result.mesh;
  mesh = filled(surface, pieces, settings);
  progress.report(0.9, "Measuring the mesh");
  const MeshQuality quality = meshQuality(mesh);
  measureRegions(mesh, pieces, std::ssize(tumours), report);
  measureBoundary(mesh, input, report);
  if (settings.order == ElementOrder::Quadratic) mesh = quadraticMesh(mesh);
  report.nodes = mesh.nodes();
  report.elements = mesh.size();
  report.degreesOfFreedom = 3 * mesh.nodes();
  report.volumeMm3 = quality.volumeMm3;
  report.inputVolumeMm3 = signedVolume(input);
  report.edgeLengthMm = quality.meanEdgeMm;
  report.minDihedralDeg = quality.minDihedralDeg;
  report.medianDihedralDeg = quality.medianDihedralDeg;
  report.minRadiusRatio = quality.minRadiusRatio;
  report.minScaledJacobian = quality.minScaledJacobian;
  progress.report(1, "Meshed");
  return result;
}

}  // namespace falciform
