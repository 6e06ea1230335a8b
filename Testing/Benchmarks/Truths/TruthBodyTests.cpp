#include "Testing/Benchmarks/Truths/TruthBody.h"

#include <gtest/gtest.h>

#include <numbers>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform::bench {
namespace {

const Surface& liver() {
  static const Surface made = [] {
    SyntheticLiverSettings shape;
    shape.edgeLengthMm = 4;
    shape.voxelMm = 3;
    return makeSyntheticLiver(shape).surface;
  }();
  return made;
}

constexpr double kEdgeMm = 18;  // coarse, for speed: nothing is solved here

/// What the plan asks of each constrained node, by where it pushes: held ones stay.
struct Held {
  Points fixed, pushed;
  VectorXd pushesMm;
};
Held heldNodes(const TruthBody& body) {
  const verification::HeldBody& held = body.problem.body;
  std::vector<int> fixed, pushed;
  std::vector<double> pushes;
  for (const NodeConstraint& c : held.constraints) {
    if (c.valuesMm.isZero()) {
      fixed.push_back(c.node);
    } else {
      pushed.push_back(c.node);
      pushes.push_back(c.valuesMm.norm());
    }
  }
  return {held.mesh.points(fixed, Eigen::all), held.mesh.points(pushed, Eigen::all),
          Eigen::Map<VectorXd>(pushes.data(), static_cast<Index>(pushes.size()))};
}

TEST(TruthBody, TumourLiesInsideAndHasItsSize) {
  const TruthPlan plan = drawTruth(3, PackedLobe::Left);
  const TruthBody body = truthBody(liver(), plan, kEdgeMm);
  const ClosestPlace nearest = TriangleTree(liver()).closest(body.tumourCentreMm);
  EXPECT_LT(nearest.side, 0);
  EXPECT_GT(nearest.distance, plan.tumourRadiusMm + 8);
  const TetrahedralMesh& mesh = body.problem.body.mesh;
  double volume = 0;
  for (Index e = 0; e < mesh.size(); ++e)
    if (mesh.regionOf(e) == 1) volume += cornerVolume(mesh, e);
  const double ball = 4.0 / 3 * std::numbers::pi * std::pow(plan.tumourRadiusMm, 3);
  EXPECT_NEAR(volume / ball, 1, 0.05);  // of a ball of 642 corners remeshed to the edge length
  const auto& materials = body.problem.body.materials;
  EXPECT_DOUBLE_EQ(materials[1].youngsModulusMPa / materials[0].youngsModulusMPa, plan.tumourFactor);
}

TEST(TruthBody, PacksPushByWhatWasDrawnAndStayClearOfWhatIsHeld) {
  for (const PackedLobe lobe : {PackedLobe::Left, PackedLobe::Right}) {
    const TruthPlan plan = drawTruth(4, lobe);
    const TruthBody body = truthBody(liver(), plan, kEdgeMm);
    const Held held = heldNodes(body);
    ASSERT_GT(held.fixed.rows(), 10);
    ASSERT_GT(held.pushed.rows(), 3);
    const Pack& pack = plan.packs[lobe == PackedLobe::Left ? 0 : 1];
    EXPECT_LE(held.pushesMm.maxCoeff(), pack.pushMm);
    EXPECT_GE(held.pushesMm.minCoeff(), 0.5 * pack.pushMm);  // a dome, never lower than half
    double gap = 1e9;
    for (Index p = 0; p < held.pushed.rows(); ++p)
      gap = std::min(gap, (held.fixed.rowwise() - held.pushed.row(p)).rowwise().norm().minCoeff());
    // 25 mm between the faces' centres; their corners lie up to two thirds of a long edge from these.
    EXPECT_GT(gap, 25 - 2 * kEdgeMm * 2 / 3);
    // A towel is no wider than drawn: along the surface, so across space as well.
    const Eigen::RowVector3d centre = held.pushed.colwise().mean();
    EXPECT_LT((held.pushed.rowwise() - centre).rowwise().norm().maxCoeff(), 2 * pack.extentMm + kEdgeMm);
    EXPECT_GT(body.heldShare, 0.005);
    EXPECT_LT(body.heldShare, 0.2);
  }
}

TEST(TruthBody, AWideTowelUnderBothLobesIsTwoTowels) {
  const TruthPlan plan = drawTruth(4, PackedLobe::Both);
  const Held left = heldNodes(truthBody(liver(), drawTruth(4, PackedLobe::Left), kEdgeMm)),
             right = heldNodes(truthBody(liver(), drawTruth(4, PackedLobe::Right), kEdgeMm)),
             both = heldNodes(truthBody(liver(), plan, kEdgeMm));
  EXPECT_EQ(both.fixed.rows(), left.fixed.rows());
  EXPECT_LE(both.pushed.rows(), left.pushed.rows() + right.pushed.rows());
  EXPECT_GT(both.pushed.rows(), std::max(left.pushed.rows(), right.pushed.rows()));
}

TEST(TruthBody, ATumourThatHasNoRoomIsRefusedInWords) {
  TruthPlan plan = drawTruth(3, PackedLobe::Left);
  plan.tumourRadiusMm = 90;
  try {
    static_cast<void>(truthBody(liver(), plan, kEdgeMm));
    FAIL() << "a tumour of 180 mm across fits into no liver";
  } catch (const InputError& refused) {
    EXPECT_NE(std::string(refused.what()).find("no room"), std::string::npos) << refused.what();
  }
}

}  // namespace
}  // namespace falciform::bench
