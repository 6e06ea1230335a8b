#include "Testing/Benchmarks/Truths/TruthBody.h"

#include <algorithm>

#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Crossings.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::bench {
namespace {

constexpr double kClearanceMm = 25;     // between what is held and what is packed
constexpr double kDome = 0.25;          // height of a pack by its radius
constexpr double kTumourDepthMm = 8;    // of tissue over the tumour, at least
constexpr double kLigamentMm = 12;      // of the falciform ligament's upper end, where held
constexpr double kLeastShare = 0.3;     // of the load: less is not worth a case
constexpr double kLeastDetJ = 0.1;      // beyond, tissue would tear
constexpr std::uint64_t kTumour = 100;  // stream of its place; the packs' stand in the plan

Vector3d placeOfTumour(const Surface& preop, const TruthPlan& plan) {
  const TriangleTree tree(preop);
  const auto box = boundingBox(preop.points);
  Draws draws(plan.seed, kTumour);
  for (int attempt = 0; attempt < 10000; ++attempt) {
    Vector3d place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = draws.uniform(box(0, axis), box(1, axis));
    const ClosestPlace nearest = tree.closest(place);
    if (nearest.side < 0 && nearest.distance > plan.tumourRadiusMm + kTumourDepthMm) return place;
  }
  throw InputError("the liver has no room for a tumour of radius " + std::to_string(plan.tumourRadiusMm) +
                   " mm; draw another seed");
}

std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

/// What grows fast to the diaphragm and around the vena cava, and perhaps the falciform ligament's upper end.
std::vector<int> heldFaces(const Surface& preop, const SupportSites& sites, const TruthPlan& plan) {
  const std::vector<int> behind = joined(sites.posteriorBed, sites.venaCava);
  const double t = plan.heldTowardsVenaCava;
  const Vector3d centre = (1 - t) * centreOf(sites, sites.posteriorBed) + t * centreOf(sites, sites.venaCava);
  std::vector<int> held = packingSite(sites, centre, plan.heldRadiusMm, behind);
  if (plan.venaCavaHeld) held = joined(held, sites.venaCava);
  if (!plan.ligamentHeld) return held;
  const std::vector<int> painted = pointsOfPatch(preop, patch::kFalciform);
  const int top = *std::max_element(painted.begin(), painted.end(),
                                    [&](int a, int b) { return preop.points(a, 2) < preop.points(b, 2); });
  std::vector<int> ligament;
  for (Index f = 0; f < sites.centres.rows(); ++f)
    if ((sites.centres.row(f) - preop.points.row(top)).norm() < kLigamentMm)
      ligament.push_back(static_cast<int>(f));
  return joined(held, ligament);
}

std::vector<int> clearOf(const SupportSites& sites, const std::vector<int>& faces,
                         const std::vector<int>& of) {
  std::vector<int> clear;
  for (const int f : faces)
    if ((sites.centres(of, Eigen::all).rowwise() - sites.centres.row(f)).rowwise().norm().minCoeff() >
        kClearanceMm)
      clear.push_back(f);
  return clear;
}

Vector3d inward(const BoundaryFaces& faces, const std::vector<int>& region) {
  return -faces.areaVectors(region, Eigen::all).colwise().sum().transpose().normalized();
}

/// A towel is a dome: it pushes most in its middle and 0.6 of that at its rim, beyond which the tissue is
/// free.
void addPack(const TruthPlan& plan, const Pack& pack, const SupportSites& sites, const BoundaryFaces& faces,
             const std::vector<int>& underside, const Points& nodes, std::vector<NodeConstraint>& constraints,
             std::vector<char>& taken) {
  if (underside.empty())
    throw InputError("no place for a pack is left beside what is held; draw another seed");
  Draws draws(plan.seed, pack.place);
  const auto any = static_cast<std::size_t>(draws.uniform() * static_cast<double>(underside.size()));
  const Vector3d middle = centreOf(sites, underside),
                 centre = middle + pack.offCentre * (sites.centres.row(underside[any]).transpose() - middle);
  const std::vector<int> site = packingSite(sites, centre, pack.extentMm, underside);
  const Vector3d siteCentre = centreOf(sites, site),
                 direction = (inward(faces, site) - pack.lean * Vector3d::UnitY()).normalized();
  for (const int f : site)
    for (int k = 0; k < faces.nodesPerFace(); ++k) {
      const int node = faces.nodes(f, k);
      if (taken[static_cast<std::size_t>(node)]) continue;
      taken[static_cast<std::size_t>(node)] = 1;
      const double r = (nodes.row(node).transpose() - siteCentre).norm() / pack.extentMm;
      const double dome = std::min(kDome * pack.extentMm, 0.5 * pack.pushMm);
      const double push = pack.pushMm - dome * std::min(r * r, 1.0);
      constraints.push_back({.node = node,
                             .count = pack.sticks ? 3 : 1,
                             .frame = frameAlong(direction),
                             .valuesMm = Vector3d(push, 0, 0)});
    }
}

}  // namespace

TruthBody truthBody(const Surface& preop, const TruthPlan& plan, double edgeMm) {
  TruthBody body;
  body.tumourCentreMm = placeOfTumour(preop, plan);
  MeshSettings meshing;
  meshing.edgeLengthMm = edgeMm;
  LiverMesh made = meshLiver(preop, {test::sphere(plan.tumourRadiusMm, 3, body.tumourCentreMm)}, meshing);
  body.warnings = made.report.warnings;
  verification::HeldBody& held = body.problem.body;
  held.mesh = std::move(made.mesh);
  const Material liver{.youngsModulusMPa = plan.liverKPa * 1e-3, .poissonsRatio = plan.poissonsRatio};
  Material tumour = liver;
  tumour.youngsModulusMPa *= plan.tumourFactor;
  held.materials = {liver, tumour};
  held.forces = Points::Zero(held.mesh.nodes(), 3);

  const BoundaryFaces faces = boundaryFaces(held.mesh);
  const SupportSites sites = findSupportSites(preop, held.mesh, faces);
  std::vector<char> taken(static_cast<std::size_t>(held.mesh.nodes()), 0);
  const std::vector<int> fixed = heldFaces(preop, sites, plan);
  for (const int f : fixed) {
    body.heldShare += sites.areasMm2(f) / sites.areasMm2.sum();
    for (int k = 0; k < faces.nodesPerFace(); ++k) {
      const int node = faces.nodes(f, k);
      if (!taken[static_cast<std::size_t>(node)]) held.constraints.push_back({.node = node});
      taken[static_cast<std::size_t>(node)] = 1;
    }
  }
  const std::array<const std::vector<int>*, 2> undersides{&sites.leftUnderside, &sites.rightUnderside};
  for (std::size_t side = 0; side < 2; ++side)
    if (plan.packs[side].pushMm > 0)
      addPack(plan, plan.packs[side], sites, faces, clearOf(sites, *undersides[side], fixed),
              held.mesh.points, held.constraints, taken);
  std::sort(held.constraints.begin(), held.constraints.end(),
            [](const NodeConstraint& a, const NodeConstraint& b) { return a.node < b.node; });
  body.problem.name = "truth";
  body.problem.gravityMPerS2 = plan.gravityChangeMPerS2;
  body.problem.neoHookean = true;
  return body;
}

TruthState solveTruth(const TruthBody& body, const std::filesystem::path& calculix,
                      const std::filesystem::path& folder) {
  const TetrahedralMesh& mesh = body.problem.body.mesh;
  std::vector<verification::LoadState> path =
      verification::loadPathWithCalculix(body.problem, calculix, folder);
  TruthState state;
  const auto refuse = [&](double share, const std::string& why) {
    state.refused.push_back("share " + std::to_string(share) + ": " + why);
  };
  if (path.back().share < 1 - 1e-6) refuse(1, "no convergence");
  for (; !path.empty() && path.back().share > kLeastShare; path.pop_back()) {
    state.share = path.back().share;
    state.displacements = std::move(path.back().displacements);
    state.minDetJ = checkDeformation(mesh, state.displacements).minDetJ;
    if (state.minDetJ < kLeastDetJ) {
      refuse(state.share, "a volume is pressed to " + std::to_string(state.minDetJ) + " of itself");
      continue;
    }
    TetrahedralMesh moved = mesh;
    moved.points += state.displacements;
    if (selfCrossings(boundarySurface(moved, boundaryFaces(mesh)).surface).empty()) return state;
    refuse(state.share, "the surface cuts through itself");
  }
  std::string reasons;
  for (const std::string& reason : state.refused) reasons += "; " + reason;
  throw std::runtime_error("no state found" + reasons);
}

}  // namespace falciform::bench
