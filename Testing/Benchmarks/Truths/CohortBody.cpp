#include "Testing/Benchmarks/Truths/CohortBody.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "Logic/Biomechanics/CorotationalWarp.h"
#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::bench {
namespace {

constexpr double kFadeMm = 40;  // beside what is held
constexpr double kFront = 0.5;  // cosine to the anterior direction of faces of the front
constexpr double kLeastDetJ = 0.1, kLeastShare = 0.25;

std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  return a;
}

/// Moves the nodes of faces that look to the front forwards or backwards, less the nearer they are to what is
/// held; they may slide across.
void moveFront(const FrontPattern& pattern, const TetrahedralMesh& mesh, const BoundaryFaces& faces,
               const GroovePlane& groove, std::vector<NodeConstraint>& constraints) {
  double left = 1, right = 1;  // mm, how far the liver reaches to either side
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const double l = groove.leftOf(mesh.points.row(n).transpose());
    left = std::max(left, l);
    right = std::max(right, -l);
  }
  const auto box = boundingBox(mesh.points);
  std::vector<char> taken(static_cast<std::size_t>(mesh.nodes()), 0);
  std::vector<int> heldNodes;
  for (const NodeConstraint& constraint : constraints) {
    taken[static_cast<std::size_t>(constraint.node)] = 1;
    heldNodes.push_back(constraint.node);
  }
  const KdTree held(mesh.points, heldNodes);
  for (Index f = 0; f < faces.size(); ++f) {
    if (-faces.areaVectors(f, 1) < kFront * faces.areaVectors.row(f).norm()) continue;
    for (int k = 0; k < faces.nodesPerFace(); ++k) {
      const int node = faces.nodes(f, k);
      if (std::exchange(taken[static_cast<std::size_t>(node)], 1) != 0) continue;
      const Vector3d place = mesh.points.row(node).transpose();
      const double l = groove.leftOf(place), u = l > 0 ? l / left : l / right,
                   v = 2 * (place.z() - box(0, 2)) / (box(1, 2) - box(0, 2)) - 1,
                   fades = 1 - std::exp(-held.nearest(place).squaredDistance / (kFadeMm * kFadeMm));
      constraints.push_back({.node = node,
                             .count = 1,
                             .frame = frameAlong(-Vector3d::UnitY()),
                             .valuesMm = Vector3d(fades * pattern.at(u, v), 0, 0)});
    }
  }
}

}  // namespace

CohortBody cohortBody(const Surface& preop, const CohortPlan& plan, double edgeMm) {
  MeshSettings meshing;
  meshing.edgeLengthMm = edgeMm;
  CohortBody made;
  verification::HeldBody& body = made.body;
  body.mesh = meshLiver(preop, {}, meshing).mesh;
  body.materials = {{.youngsModulusMPa = plan.liverKPa * 1e-3}};
  body.forces = weightForces(body.mesh, body.materials, plan.gravityChangeMPerS2);

  const BoundaryFaces faces = boundaryFaces(body.mesh);
  const SupportSites sites = findSupportSites(preop, body.mesh, faces);
  const Vector3d bareArea = (centreOf(sites, sites.posteriorBed) + centreOf(sites, sites.venaCava)) / 2;
  std::vector<int> held =
      joined(packingSite(sites, bareArea, plan.heldRadiusMm, joined(sites.posteriorBed, sites.venaCava)),
             sites.venaCava);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  made.heldShare = sites.areasMm2(held).sum() / sites.areasMm2.sum();
  const std::vector<Support> supports{
      {.name = "bare area", .kind = SupportKind::Fixed, .faces = held},
      {.name = "bed", .kind = SupportKind::Sliding, .faces = sites.posteriorBed}};
  body.constraints = nodeConstraints(faces, nodeNormals(faces, body.mesh.nodes()), supports);
  if (plan.front) moveFront(*plan.front, body.mesh, faces, sites.groove, body.constraints);
  std::sort(body.constraints.begin(), body.constraints.end(),
            [](const NodeConstraint& a, const NodeConstraint& b) { return a.node < b.node; });
  return made;
}

CohortState solveCohort(const CohortBody& body) {
  std::vector<int> anchors;
  for (const NodeConstraint& constraint : body.body.constraints)
    if (constraint.count == 3) anchors.push_back(constraint.node);
  const CorotationalWarp warp(body.body.mesh, anchors);
  const Points linear = verification::solve(body.body).displacements;
  CohortState state;
  for (; state.share >= kLeastShare; state.share *= 0.8) {
    state.displacements = warp.apply(state.share * linear);
    state.minDetJ = checkDeformation(body.body.mesh, state.displacements).minDetJ;
    if (state.minDetJ >= kLeastDetJ) return state;
  }
  throw InputError("even " + std::to_string(kLeastShare) + " of the loads press a volume to " +
                   std::to_string(state.minDetJ) + " of itself; draw another seed");
}

}  // namespace falciform::bench
