// A whole case on a block, from its solution to its files and back: what a reader of the real cases finds.
#include "Testing/Benchmarks/Truths/TruthFiles.h"

#include <gtest/gtest.h>

#include <fstream>

#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Benchmarks/Truths/TruthTable.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::bench {
namespace {

const Vector3d kSize(160, 120, 80);

/// A ball bent by a smooth field, which is told to each of its parts as a solution would be.
struct Case {
  TruthPlan plan = drawTruth(11, PackedLobe::Both);
  Surface preop, moved;
  TruthBody body;
  TruthState state;
  TruthTargets targets;
  TruthScan scan;

  explicit Case(double noiseMm = 1, double outlierShare = 0.02) {
    plan.noiseMm = noiseMm;
    plan.outlierShare = outlierShare;
    preop = test::sphere(35, 5, kSize / 2);
    preop.patch.assign(static_cast<std::size_t>(preop.size()), patch::kNone);
    for (Index v = 0; v < preop.size(); ++v)
      if (std::abs(preop.points(v, 0) - kSize.x() / 2) < 4)
        preop.patch[static_cast<std::size_t>(v)] = patch::kFalciform;
    TetrahedralMesh& mesh = body.problem.body.mesh;
    mesh = quadraticMesh(test::blockMesh(kSize, {8, 6, 4}));
    // Quadratic, so that the elements hold it exactly.
    state.displacements = mesh.points;
    for (Index n = 0; n < mesh.nodes(); ++n) state.displacements.row(n) = field(mesh.points.row(n));
    moved = preop;
    moved.points += Points(MeshPlaces(mesh, preop.points).interpolate(state.displacements));
    targets = drawTargets(mesh, state.displacements, 60, plan.seed);
    scan = scanTruth(moved, plan);
  }

  static Eigen::RowVector3d field(const Eigen::RowVector3d& p) {
    return {5 + 0.001 * p.y() * p.y(), -0.05 * p.x(), 0.0008 * p.x() * p.y()};
  }
  void write(const std::filesystem::path& folder) const {
    writeTruth(folder, 99, 14, plan, preop, moved, scan, targets, body, state);
  }
};

TEST(TruthFiles, ReaderOfTheRealCasesFindsTheSameCase) {
  const Case made;
  const test::TemporaryFolder cases;
  made.write(cases / "ircad99_both");
  EXPECT_EQ(test::updateCaseNames(cases.path()), std::vector<std::string>{"ircad99_both"});
  const test::UpdateCase read = test::readUpdateCase("ircad99_both", cases.path());
  EXPECT_EQ(read.preop.patch, made.preop.patch);
  EXPECT_EQ(read.scan.patch, made.scan.scan.patch);
  // Files keep single precision: 1e-5 mm of 200.
  EXPECT_LT((read.preop.points - made.preop.points).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((read.scan.points - made.scan.scan.points).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_DOUBLE_EQ(read.coverage, made.scan.coverage);
  EXPECT_NEAR(read.optimalRigidMm, optimalRigidMm(made.targets), 1e-9);
}

TEST(TruthFiles, TargetsAndSurfaceOfBothFramesTellTheSameMotion) {
  const Case made;
  const test::TemporaryFolder cases;
  made.write(cases / "one");
  const test::UpdateCase read = test::readUpdateCase("one", cases.path());
  const nlohmann::json truth = readJsonFile(cases / "one" / "truth.json");
  const Isometry3d preopFromScanner =
      rigidFromJson(truth.at("scannerFromPreop_rigid"), "scannerFromPreop_rigid").inverse();
  const Points back = transformed(read.targetsScanner, preopFromScanner);
  ASSERT_EQ(back.rows(), 60);
  for (Index i = 0; i < back.rows(); ++i) {
    const Eigen::RowVector3d before = read.targetsPreop.row(i);
    EXPECT_LT((back.row(i) - before - Case::field(before)).norm(), 1e-8) << i;
  }
  const Surface surface = readSurface(cases / "one" / "truth_surface.vtp").value;
  const Points surfaceBack = transformed(surface.points, preopFromScanner);
  ASSERT_EQ(surface.size(), read.preop.size());
  EXPECT_EQ(surface.triangles, read.preop.triangles);
  for (Index v = 0; v < surface.size(); ++v) {
    const Eigen::RowVector3d before = read.preop.points.row(v);
    ASSERT_LT((surfaceBack.row(v) - before - Case::field(before)).norm(), 1e-3) << v;
  }
  EXPECT_NEAR(truth.at("target_displacement_mean_mm").get<double>(),
              (back - read.targetsPreop).rowwise().norm().mean(), 1e-8);
}

TEST(TruthFiles, SameFieldsAsTheRealCasesAndWhatWasDrawn) {
  const Case made;
  const test::TemporaryFolder cases;
  made.write(cases / "one");
  const nlohmann::json truth = readJsonFile(cases / "one" / "truth.json");
  for (const char* field :
       {"frame_preop", "frame_scan", "scannerFromPreop_rigid", "coverage", "noise_mm", "outlier_fraction",
        "mode", "targets_preop_mm", "targets_scanner_mm", "target_displacement_mean_mm",
        "target_displacement_max_mm", "optimal_rigid_target_error_mean_mm", "solver", "scan_points",
        "scan_patch_points", "preop_patch_points"})
    EXPECT_TRUE(truth.contains(field)) << field;
  EXPECT_EQ(truth.at("mode"), "both");
  EXPECT_EQ(truth.at("seed"), 11);
  EXPECT_EQ(truth.at("scan_points"), made.scan.scan.size());
  EXPECT_TRUE(truth.at("drawn").contains("pack_left"));
  EXPECT_TRUE(truth.at("drawn").contains("pack_right"));
}

TEST(TruthFiles, TableHasARowForEachCaseAndRefusesAFolderWithout) {
  const test::TemporaryFolder cases;
  EXPECT_THROW(static_cast<void>(truthTable(cases.path())), InputError);
  const Case made;
  made.write(cases / "b");
  made.write(cases / "a");
  const std::string table = truthTable(cases.path());
  EXPECT_LT(table.find("| a |"), table.find("| b |"));
  EXPECT_NE(table.find("2 cases"), std::string::npos) << table;
}

TEST(TruthScan, LiesOnTheMovedSurfaceButForNoiseAndOutliers) {
  const Case made(1.0, 0.02);
  const Points back = transformed(made.scan.scan.points, made.scan.scannerFromPreop.inverse());
  const TriangleTree tree(made.moved);
  std::vector<double> distances;
  Index outliers = 0;
  double squares = 0;
  for (Index i = 0; i < back.rows(); ++i) {
    const double d = tree.closest(back.row(i).transpose()).distance;
    if (d > 5)
      ++outliers;  // five times the noise; some outliers at a slant lie nearer
    else
      squares += d * d;
  }
  const auto count = static_cast<double>(back.rows());
  ASSERT_GT(count, 500);
  // Noise lies along the rays, so it shows at most in full, and at a slant in part.
  EXPECT_LT(std::sqrt(squares / count), 1.1 * made.plan.noiseMm);
  EXPECT_GT(std::sqrt(squares / count), 0.5 * made.plan.noiseMm);
  EXPECT_NEAR(static_cast<double>(outliers) / count, 0.02, 0.012);  // four standard errors, and the slant
  // The coverage comes near what was drawn, or the whole view shows no more: half of a ball at most.
  EXPECT_NEAR(made.scan.coverage, made.plan.coverage, 0.03);
}

TEST(TruthScan, IsTheSameEachTime) {
  const Case a, b;
  EXPECT_EQ(a.scan.scan.points, b.scan.scan.points);
  EXPECT_TRUE(a.scan.scannerFromPreop.isApprox(b.scan.scannerFromPreop, 0));
}

}  // namespace
}  // namespace falciform::bench
