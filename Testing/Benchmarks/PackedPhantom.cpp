#include "Testing/Benchmarks/PackedPhantom.h"

#include <stdexcept>

#include "Logic/Acquisition/Phantom.h"
#include "Logic/Acquisition/PhantomBeads.h"
#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/CorotationalWarp.h"
#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Biomechanics/SupportTemplates.h"
#include "Logic/Core/LandmarkPairs.h"
#include "Testing/Benchmarks/Truths/TruthBody.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::bench {
namespace {

constexpr double kReachMm = 100;  // of the drawn pose of a CT surface

/// The thesis's phantom has one stripe of paint: no ridge.
void keepStripe(Surface& surface) {
  for (int& label : surface.patch)
    if (label != patch::kFalciform) label = patch::kNone;
}

Material silicone() {
  const TissueSettings tissue = atlasPreset("thesis-packing").liver;
  return {.youngsModulusMPa = tissue.youngsModulusKPa * 1e-3, .poissonsRatio = tissue.poissonsRatio};
}

/// The phantom's silicone on its screw, pushed as a template says: neo-Hookean, large displacement.
TruthState byCalculix(const TetrahedralMesh& mesh, const std::vector<Support>& supports) {
  const auto calculix = verification::findCalculix();
  if (!calculix)
    throw std::runtime_error(
        "the phantom's packing needs CalculiX (ccx); install calculix-ccx, or take --truth warp");
  TruthBody body;
  body.problem.name = "phantom";
  body.problem.body = verification::heldBody(mesh, silicone(), supports);
  body.problem.body.forces = Points::Zero(mesh.nodes(), 3);
  body.problem.neoHookean = true;
  const test::TemporaryFolder folder;
  return solveTruth(body, *calculix, folder.path());
}

/// The same by linear elasticity with turns made true ones afterwards.
TruthState byWarp(const TetrahedralMesh& mesh, const std::vector<Support>& supports) {
  const verification::HeldBody body = verification::heldBody(mesh, silicone(), supports);
  std::vector<int> anchors;
  for (const NodeConstraint& constraint : body.constraints)
    if (constraint.count == 3) anchors.push_back(constraint.node);
  const ConstrainedStiffness solver(assembleStiffness(mesh, body.materials), body.constraints);
  TruthState state;
  state.displacements = CorotationalWarp(mesh, anchors).apply(solver.solve(Points::Zero(mesh.nodes(), 3)));
  state.minDetJ = checkDeformation(mesh, state.displacements).minDetJ;
  return state;
}

PackedPhantom seen(const PackedPhantoms& made, const TetrahedralMesh& mesh, const TruthState& state,
                   int seed) {
  PackedPhantom packed;
  Surface moved = made.preop;
  moved.points += Points(MeshPlaces(mesh, moved.points).interpolate(state.displacements));
  moved.normals.resize(0, 3);
  const Points before = positionsOf(made.beads),
               after = before + Points(MeshPlaces(mesh, before).interpolate(state.displacements));
  packed.before = figuresOf(before, after);
  packed.minDetJ = state.minDetJ;
  packed.share = state.share;
  const Isometry3d pose = drawnPose(static_cast<std::uint64_t>(seed), kReachMm);
  packed.full = {transformed(moved, pose, "CT"), before, transformed(after, pose), pose};
  packed.full.scan.triangles.resize(0, 3);
  VirtualScannerSettings scanner = thesisPhantom().scanner;
  scanner.seed = seed;
  VirtualScan scan = scanSurface(moved, scanner);
  packed.coverage = scan.coverage;
  packed.partial = {std::move(scan.scan), before, transformed(after, scan.scanFromPreop), scan.scanFromPreop};
  return packed;
}

}  // namespace

PackedPhantoms packedPhantoms(const PackedPhantomPlan& plan) {
  PackedPhantoms made;
  SyntheticLiverSettings shape = thesisPhantom().liver;
  made.beads = placeBeads(LiverShape(shape));
  shape.edgeLengthMm = plan.surfaceEdgeMm;
  made.preop = makeSyntheticLiver(shape).surface;
  keepStripe(made.preop);
  MeshSettings meshing;
  meshing.edgeLengthMm = plan.atlasEdgeMm;
  const TetrahedralMesh atlasMesh = meshLiver(made.preop, {}, meshing).mesh;
  made.atlas = buildAtlas(atlasMesh, findSupportSites(made.preop, atlasMesh, boundaryFaces(atlasMesh)),
                          atlasPreset("thesis-packing"));
  meshing.edgeLengthMm = plan.truthEdgeMm;
  const TetrahedralMesh mesh = meshLiver(made.preop, {}, meshing).mesh;
  const SupportSites sites = findSupportSites(made.preop, mesh, boundaryFaces(mesh));
  const auto solved = plan.calculix ? byCalculix : byWarp;
  made.packings.push_back(
      seen(made, mesh, solved(mesh, leftLobePacked(sites, plan.leftPushMm, plan.extentMm)), 1));
  made.packings.back().packing = "left";
  made.packings.push_back(
      seen(made, mesh, solved(mesh, rightLobePacked(sites, plan.rightPushMm, plan.extentMm)), 2));
  made.packings.back().packing = "right";
  return made;
}

}  // namespace falciform::bench
