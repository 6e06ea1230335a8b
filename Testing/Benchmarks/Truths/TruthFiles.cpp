#include "Testing/Benchmarks/Truths/TruthFiles.h"

#include <algorithm>

#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Draws.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform::bench {
namespace {

constexpr std::uint64_t kTargets = 300;  // stream

nlohmann::json rows(const Points& points) {
  nlohmann::json list = nlohmann::json::array();
  for (Index i = 0; i < points.rows(); ++i) list.push_back({points(i, 0), points(i, 1), points(i, 2)});
  return list;
}

nlohmann::json patchCounts(const Surface& surface) {
  std::array<int, 3> counts{};
  for (const int label : surface.patch) ++counts.at(static_cast<std::size_t>(label));
  return counts;
}

}  // namespace

TruthTargets drawTargets(const TetrahedralMesh& mesh, const Points& displacements, int count,
                         std::uint64_t seed) {
  std::vector<double> upTo;
  for (Index e = 0; e < mesh.size(); ++e)
    upTo.push_back((upTo.empty() ? 0 : upTo.back()) + cornerVolume(mesh, e));
  Draws draws(seed, kTargets);
  TruthTargets targets;
  targets.preop.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    const auto found = std::upper_bound(upTo.begin(), upTo.end(), draws.uniform() * upTo.back());
    const Index element = std::min<Index>(found - upTo.begin(), mesh.size() - 1);
    // Four exponential numbers by their sum are even over a tetrahedron.
    Eigen::RowVector4d weights;
    for (double& weight : weights) weight = -std::log(1 - draws.uniform());
    weights /= weights.sum();
    targets.preop.row(i).setZero();
    for (int k = 0; k < 4; ++k)
      targets.preop.row(i) += weights[k] * mesh.points.row(mesh.elements(element, k));
  }
  targets.moved = targets.preop + Points(MeshPlaces(mesh, targets.preop).interpolate(displacements));
  return targets;
}

double optimalRigidMm(const TruthTargets& targets) {
  return targetErrors(targets.preop, targets.moved, fitRigid(targets.preop, targets.moved)).mean();
}

nlohmann::json truthOf(const ScannerPlan& plan, const Surface& preop, const TruthScan& scan,
                       const TruthTargets& targets) {
  const VectorXd way = (targets.moved - targets.preop).rowwise().norm();
  return {{"frame_preop", "LPS mm"},
          {"frame_scan", "scanner mm"},
          {"scannerFromPreop_rigid", matrixToJson(scan.scannerFromPreop)},
          {"coverage", scan.coverage},
          {"noise_mm", plan.noiseMm},
          {"outlier_fraction", plan.outlierShare},
          {"targets_preop_mm", rows(targets.preop)},
          {"targets_scanner_mm", rows(transformed(targets.moved, scan.scannerFromPreop))},
          {"target_displacement_mean_mm", way.mean()},
          {"target_displacement_max_mm", way.maxCoeff()},
          {"optimal_rigid_target_error_mean_mm", optimalRigidMm(targets)},
          {"scan_points", scan.scan.size()},
          {"scan_patch_points", patchCounts(scan.scan)},
          {"preop_patch_points", patchCounts(preop)},
          {"seed", plan.seed}};
}

void writeTruthSurfaces(const std::filesystem::path& folder, const Surface& preop, const Surface& moved,
                        const TruthScan& scan) {
  writeSurface(folder / "preop.vtp", preop, Overwrite::Replace);
  writeSurface(folder / "scan.vtp", scan.scan, Overwrite::Replace);
  writeSurface(folder / "truth_surface.vtp", transformed(moved, scan.scannerFromPreop, "scanner"),
               Overwrite::Replace);
}

void writeTruth(const std::filesystem::path& folder, int liver, double edgeMm, const TruthPlan& plan,
                const Surface& preop, const Surface& moved, const TruthScan& scan,
                const TruthTargets& targets, const TruthBody& body, const TruthState& state) {
  nlohmann::json drawn = toJson(plan);
  drawn["tumour_centre_mm"] = {body.tumourCentreMm.x(), body.tumourCentreMm.y(), body.tumourCentreMm.z()};
  nlohmann::json truth = truthOf(plan, preop, scan, targets);
  truth.update({{"mode", kPackedLobeNames[static_cast<std::size_t>(plan.lobe)]},
                {"solver", "CalculiX, neo-Hookean C3D10, NLGEOM"},
                {"liver", "3Dircadb-" + std::to_string(liver)},
                {"mesh_edge_mm", edgeMm},
                {"mesh_nodes", body.problem.body.mesh.nodes()},
                {"held_share", body.heldShare},
                {"load_share", state.share},
                {"larger_shares_refused", state.refused},
                {"min_det_j", state.minDetJ},
                {"surface_displacement_max_mm", (moved.points - preop.points).rowwise().norm().maxCoeff()},
                {"drawn", drawn}});
  // Whoever watches the folder sees a whole case or none.
  const std::filesystem::path unfinished = folder.string() + ".unfinished";
  std::filesystem::remove_all(unfinished);
  std::filesystem::create_directories(unfinished);
  writeTruthSurfaces(unfinished, preop, moved, scan);
  writeJsonFile(unfinished / "truth.json", truth, Overwrite::Replace);
  std::filesystem::rename(unfinished, folder);
}

}  // namespace falciform::bench
