#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Biomechanics/Supports.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

/// A block bent into a lopsided bean, so that no rigid motion fits it twice.
TetrahedralMesh bean() {
  TetrahedralMesh mesh = blockMesh({120, 80, 50}, {12, 8, 5});
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const double x = mesh.points(n, 0), y = mesh.points(n, 1);
    mesh.points(n, 2) =
        mesh.points(n, 2) * (1 - 0.35 * x / 120) + 0.004 * (x - 40) * (x - 40) * 0.3 + 0.05 * y;
    mesh.points(n, 1) = y * (1 - 0.3 * std::pow(x / 120, 2)) + 8 * std::sin(x / 25);
  }
  return quadraticMesh(mesh);
}

/// Made once: some seconds of solves.
const UpdateModel& model() {
  static const UpdateModel made = [] {
    const TetrahedralMesh mesh = bean();
    return UpdateModel(boundarySurface(mesh, boundaryFaces(mesh)).surface,
                       solveSurfaceLoads(mesh, {Material{}}, {.centres = 30, .radiusMm = 18}));
  }();
  return made;
}

/// A deformation within the model's reach, of 4 mm RMS, and what a scanner above would see of it.
struct Truth {
  UpdateResult deformed;
  Points before, after;  ///< places inside
  Surface scan;
};

Truth bent(double noiseMm) {
  Truth truth;
  const LoadResponses& loads = model().responses();
  VectorXd coefficients = VectorXd::Zero(loads.loads());
  Draws draws(11);
  for (Index c = 0; c < loads.centres.rows();
       ++c)  // pressed from below only, where the scanner does not look
    if (loads.centres(c, 2) < 15) coefficients.segment<3>(3 * c) = draws.normal3();
  Points field(loads.mesh.nodes(), 3);
  Eigen::Map<VectorXd>(field.data(), field.size()) =
      loads.responses.cast<double>().transpose() * coefficients;
  field *= 4 / std::sqrt(field.rowwise().squaredNorm().mean());
  truth.deformed.displacements = field;
  truth.deformed.scanFromPreop = randomMotion(5);
  std::vector<int> inside;
  for (Index n = 0; n < loads.mesh.nodes(); n += 7) inside.push_back(static_cast<int>(n));
  truth.before = loads.mesh.points(inside, Eigen::all);
  truth.after = scanFromPreop(model(), truth.deformed, truth.before);
  const BoundaryFaces faces = boundaryFaces(loads.mesh);
  std::vector<Vector3d> seen;  // all nodes of faces that look up
  for (Index f = 0; f < faces.size(); ++f)
    if (faces.areaVectors(f, 2) > 0.3 * faces.areaVectors.row(f).norm())
      for (int k = 0; k < 6; ++k) seen.push_back(loads.mesh.points.row(faces.nodes(f, k)).transpose());
  Points places(static_cast<Index>(seen.size()), 3);
  for (Index i = 0; i < places.rows(); ++i) places.row(i) = seen[static_cast<std::size_t>(i)].transpose();
  truth.scan.points = scanFromPreop(model(), truth.deformed, places);
  for (Index i = 0; i < places.rows(); ++i) truth.scan.points.row(i) += noiseMm * draws.normal3().transpose();
  truth.scan.frame = "scanner";
  return truth;
}

Isometry3d nudged(const Isometry3d& pose) {
  Isometry3d nudge = Isometry3d::Identity();
  nudge.linear() = Eigen::AngleAxisd(0.03, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  nudge.translation() = Vector3d(2, -3, 1);
  return nudge * pose;
}

double meanError(const UpdateResult& update, const Truth& truth) {
  return (scanFromPreop(model(), update, truth.before) - truth.after).rowwise().norm().mean();
}

TEST(SurfaceLoads, AnswersAreBalancedAndFreeOfRigidMotion) {
  const LoadResponses& loads = model().responses();
  const auto motions = rigidMotions(loads.mesh.points);
  const VectorXd volumes = nodalVolumes(loads.mesh);
  for (Index load = 0; load < loads.loads(); load += 7) {
    VectorXd field = loads.responses.row(load).transpose().cast<double>();
    for (Index n = 0; n < volumes.size(); ++n) field.segment<3>(3 * n) *= volumes[n] / volumes.sum();
    // Single precision leaves about 1e-6 of the field's own size.
    EXPECT_LT((motions.transpose() * field).cwiseAbs().maxCoeff(), 1e-5 * loads.rmsMm[load]);
  }
}

TEST(ModelUpdate, RecoversABendingThatItsLoadsCanMake) {
  const Truth truth = bent(0.1);
  const Isometry3d start = nudged(truth.deformed.scanFromPreop);
  UpdateResult rigid;
  rigid.scanFromPreop = start;
  rigid.displacements = Points::Zero(model().responses().mesh.nodes(), 3);
  ASSERT_GT(meanError(rigid, truth), 4);  // what there is to be mended, mm
  const UpdateResult update = updateModel(model(), truth.scan, start);
  // Half the body is unseen, and closest points see no motion along the surface: a third of the 4 mm may
  // remain.
  EXPECT_LT(meanError(update, truth), 1.4);
  EXPECT_TRUE(update.converged) << update.stopReason;
  EXPECT_GT(update.minDetJ, 0);
  EXPECT_LT(update.rmsMm, 0.6);
}

TEST(ModelUpdate, LeavesAStiffBodyAlone) {
  Truth truth = bent(0);
  truth.deformed.displacements.setZero();
  truth.scan.points = transformed(
      boundarySurface(model().responses().mesh, boundaryFaces(model().responses().mesh)).surface.points,
      truth.deformed.scanFromPreop);
  const UpdateResult update = updateModel(model(), truth.scan, nudged(truth.deformed.scanFromPreop));
  EXPECT_LT(update.largestMm, 0.3);  // mm of bending found where there is none
  truth.after = transformed(truth.before, truth.deformed.scanFromPreop);
  EXPECT_LT(meanError(update, truth), 0.15);
}

TEST(ModelUpdate, ExpectedErrorIsLeastUnderTheScan) {
  const Truth truth = bent(0.1);
  const UpdateResult update = updateModel(model(), truth.scan, truth.deformed.scanFromPreop);
  Points ends(2, 3);
  ends << 60, 40, 45, 60, 40, 3;  // below the seen face, and at the far one
  const VectorXd expected = expectedErrorMm(model(), update, ends);
  EXPECT_GT(expected.minCoeff(), 0);
  EXPECT_LT(expected[0], expected[1]);
}

TEST(ModelUpdate, SameBitsForAnyNumberOfThreads) {
  const Truth truth = bent(0.2);
  const UpdateSettings few{.maxIterations = 6};
  std::vector<UpdateResult> results;
  for (const int count : {1, 2, 3}) {
    setThreads(count);
    results.push_back(updateModel(model(), truth.scan, truth.deformed.scanFromPreop, few));
  }
  setThreads(0);
  for (const UpdateResult& result : results) {
    EXPECT_EQ(result.displacements, results[0].displacements);
    EXPECT_EQ(result.scanFromPreop.matrix(), results[0].scanFromPreop.matrix());
  }
}

TEST(ModelUpdate, FollowsTheScanWhereverItLies) {
  const Truth truth = bent(0.1);
  const Isometry3d elsewhere = randomMotion(9, 400);
  const UpdateResult here = updateModel(model(), truth.scan, truth.deformed.scanFromPreop);
  const UpdateResult there = updateModel(model(), transformed(truth.scan, elsewhere, "scanner"),
                                         elsewhere * truth.deformed.scanFromPreop);
  // Rounding only, grown by some tens of Gauss-Newton steps: micrometres.
  EXPECT_LT((there.displacements - here.displacements).cwiseAbs().maxCoeff(), 1e-2);
}

TEST(ModelUpdate, TooFewPointsAreRefused) {
  Surface scan;
  scan.points = Points::Random(5, 3);
  try {
    (void)updateModel(model(), scan, Isometry3d::Identity());
    FAIL() << "five points were taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("usable points"));
  }
}

}  // namespace
}  // namespace falciform::test
