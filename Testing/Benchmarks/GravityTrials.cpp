#include "Testing/Benchmarks/GravityTrials.h"

#include <Eigen/QR>
#include <numbers>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/DesignSampling.h"
#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Biomechanics/CornerWarp.h"
#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"

namespace falciform::bench {
namespace {

constexpr double kReachMm = 100;    // of the drawn pose of a full surface
constexpr double kSeenReachMm = 2;  // rays are 1.1 mm apart, noise is 0.5 mm

Vector3d turned(const GravityDesignSettings& design, double yDeg, double zDeg) {
  constexpr double kDeg = std::numbers::pi / 180;
  const Vector3d initial = Vector3d(design.initialX, design.initialY, design.initialZ).normalized();
  return kGravityMPerS2 * (Eigen::AngleAxisd(zDeg * kDeg, Vector3d::UnitZ()) *
                               (Eigen::AngleAxisd(yDeg * kDeg, Vector3d::UnitY()) * initial) -
                           initial);
}

/// Modes' coefficients under any change of gravity, from the members': they are linear in it.
Eigen::RowVectorXd coefficientsUnder(const Atlas& atlas, const Vector3d& changeMPerS2) {
  Eigen::MatrixXd changes(static_cast<Index>(atlas.members.size()), 3);
  for (Index m = 0; m < changes.rows(); ++m)
    changes.row(m) = atlas.members[static_cast<std::size_t>(m)].gravityChangeMPerS2.transpose();
  const Eigen::MatrixXd byAxis = changes.completeOrthogonalDecomposition().solve(atlas.coefficients);
  return changeMPerS2.transpose() * byAxis;
}

/// The vertices within `reachMm` of what was scanned.
Surface seenPart(const Surface& surface, const Points& scanned, double reachMm) {
  const KdTree tree(scanned);
  std::vector<int> seen;
  for (Index i = 0; i < surface.size(); ++i)
    if (tree.nearest(surface.points.row(i).transpose()).squaredDistance < reachMm * reachMm)
      seen.push_back(static_cast<int>(i));
  return subset(surface, seen);
}

void seeTrial(const Surface& preop, const TetrahedralMesh& mesh, const Points& displacements,
              const GravityPlan& plan, std::uint64_t seed, GravityTrial& trial) {
  Surface moved = preop;
  moved.points += Points(MeshPlaces(mesh, preop.points).interpolate(displacements));
  moved.normals.resize(0, 3);
  const Points after = mesh.points + displacements;
  trial.before = figuresOf(mesh.points, after);
  trial.minDetJ = checkDeformation(mesh, displacements).minDetJ;
  const auto in = [&](const Surface& seen, const Isometry3d& pose) {
    UpdateTrial made{transformed(seen, pose, "scanner"), mesh.points, transformed(after, pose), pose};
    made.scan.triangles.resize(0, 3);
    return made;
  };
  trial.full = in(moved, drawnPose(seed, kReachMm));
  VirtualScannerSettings scanner;
  scanner.noiseMm = plan.noiseMm;
  scanner.seed = static_cast<int>(seed);
  VirtualScan seen = scanSurface(moved, scanner);
  trial.coverage = seen.coverage;
  trial.partial =
      in(seenPart(moved, transformed(seen.scan.points, seen.scanFromPreop.inverse()), kSeenReachMm),
         seen.scanFromPreop);
  trial.scanned = {std::move(seen.scan), mesh.points, transformed(after, seen.scanFromPreop),
                   seen.scanFromPreop};
}

}  // namespace

GravityExperiment gravityExperiment(const GravityPlan& plan) {
  GravityExperiment made;
  SyntheticLiverSettings shape;
  shape.edgeLengthMm = plan.surfaceEdgeMm;
  made.preop = makeSyntheticLiver(shape).surface;
  MeshSettings meshing;
  meshing.edgeLengthMm = plan.meshEdgeMm;
  const TetrahedralMesh mesh = meshLiver(made.preop, {}, meshing).mesh;
  made.atlas = buildAtlas(mesh, findSupportSites(made.preop, mesh, boundaryFaces(mesh)),
                          atlasPreset("thesis-gravity"));
  const CornerWarp warp(mesh);
  Draws draws(plan.seed);
  for (int k = 0; k < plan.trials; ++k) {
    GravityTrial trial;
    const double most = made.atlas.design.gravityDirections.maxAngleDeg;
    trial.yDeg = draws.uniform(-most, most);
    trial.zDeg = draws.uniform(-most, most);
    const Points displacements = fieldOf(
        made.atlas.modes,
        coefficientsUnder(made.atlas, turned(made.atlas.design.gravityDirections, trial.yDeg, trial.zDeg)));
    const std::uint64_t seed = plan.seed + 1 + static_cast<std::uint64_t>(k);
    GravityTrial turnedTruly = trial;
    seeTrial(made.preop, mesh, displacements, plan, seed, trial);
    seeTrial(made.preop, mesh, displacements + warp.apply(displacements).added, plan, seed, turnedTruly);
    made.inside.push_back(std::move(trial));
    made.turned.push_back(std::move(turnedTruly));
  }
  return made;
}

}  // namespace falciform::bench
