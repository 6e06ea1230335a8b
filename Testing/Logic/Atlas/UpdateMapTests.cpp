#include <gmock/gmock.h>

#include "Logic/Atlas/UpdateMap.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Logic/Atlas/BentBlock.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

class UpdateMapOf : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(LinearAndQuadratic, UpdateMapOf, testing::Bool());

bool inBlock(const Vector3d& place) {
  return (place.array() > 0).all() && (place.array() < Eigen::Array3d(120, 80, 50)).all();
}

TEST_P(UpdateMapOf, ThereAndBackIsExactInsideAndOutside) {
  const BentBlock block = bentBlock(GetParam());
  const UpdateMap map(block.mesh, block.displacements, randomMotion(5));
  const Points preop = placesAroundBlock(4000, 50, 1);
  const std::vector<PreopPlace> back = map.preopFromScan(map.scanFromPreop(preop));
  int inside = 0;
  for (Index i = 0; i < preop.rows(); ++i) {
    const PreopPlace& place = back[static_cast<std::size_t>(i)];
    const Vector3d truth = preop.row(i).transpose();
    EXPECT_EQ(place.inside, inBlock(truth));
    inside += place.inside ? 1 : 0;
    EXPECT_LT((place.preop - truth).norm(), 1e-6) << truth.transpose();  // mm, as promised
    EXPECT_LT(place.missMm, 1e-8);
    const Vector3d nearest = truth.cwiseMax(0).cwiseMin(Vector3d(120, 80, 50));
    EXPECT_NEAR(place.outsideMm, (truth - nearest).norm(), 1e-6);
  }
  EXPECT_GT(inside, 300);
}

TEST_P(UpdateMapOf, TheContinuationJoinsTheMeshWithoutAStepOrAKink) {
  const BentBlock block = bentBlock(GetParam());
  const UpdateMap map(block.mesh, block.displacements, Isometry3d::Identity());
  Draws draws(2);
  for (int i = 0; i < 300; ++i) {
    const Vector3d face(120 * draws.uniform(), 80 * draws.uniform(), 50);
    const auto moved = [&](double outMm) {
      const Vector3d place = face + Vector3d(0, 0, outMm);
      return Vector3d(map.bentFromPreop(place) - place);
    };
    const double step = 1e-3;
    EXPECT_LT((moved(step) - moved(-step)).norm(), 2 * step);  // mm: strains stay below 1
    const Vector3d slopeIn = (moved(-step) - moved(-2 * step)) / step,
                   slopeOut = (moved(2 * step) - moved(step)) / step;
    // Per mm: second derivatives of the bending are below 0.01 / mm, the band's share of 10 mm adds its own.
    EXPECT_LT((slopeIn - slopeOut).norm(), 1e-3);
  }
}

TEST_P(UpdateMapOf, SpaceIsNowhereTurnedInsideOut) {
  const BentBlock block = bentBlock(GetParam(), 20);
  const UpdateMap map(block.mesh, block.displacements, Isometry3d::Identity());
  const Points places = placesAroundBlock(4000, 60, 3);
  const double step = 1e-4;
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector3d place = places.row(i).transpose();
    Matrix3d slope;
    for (int a = 0; a < 3; ++a)
      slope.col(a) = (map.bentFromPreop(place + step * Vector3d::Unit(a)) -
                      map.bentFromPreop(place - step * Vector3d::Unit(a))) /
                     (2 * step);
    EXPECT_GT(slope.determinant(), 0.1) << place.transpose();
  }
}

TEST(UpdateMap, BeyondTheMarginThereIsTheRigidMotionAlone) {
  const BentBlock block = bentBlock(true);
  const Isometry3d motion = randomMotion(7);
  const UpdateMap map(block.mesh, block.displacements, motion);
  EXPECT_GE(map.marginMm(), 30);
  Points far(2, 3);
  far << 60, 40, 50 + map.marginMm() + 20, -map.marginMm() - 20, 0, 0;
  EXPECT_LT((map.scanFromPreop(far) - transformed(far, motion)).norm(), 1e-12);
}

TEST(UpdateMap, ALargerBendingHasALongerMargin) {
  const BentBlock little = bentBlock(false, 1), much = bentBlock(false, 40);
  EXPECT_EQ(UpdateMap(little.mesh, little.displacements, Isometry3d::Identity()).marginMm(), 30);
  EXPECT_GT(UpdateMap(much.mesh, much.displacements, Isometry3d::Identity()).marginMm(), 60);
}

TEST(UpdateMap, WithoutBendingItIsTheRigidMotion) {
  const BentBlock block = bentBlock(true, 0);
  const Isometry3d motion = randomMotion(8);
  const UpdateMap map(block.mesh, block.displacements, motion);
  const Points preop = placesAroundBlock(200, 60, 4);
  // mm: rounding of products of 200 mm.
  EXPECT_LT((map.scanFromPreop(preop) - transformed(preop, motion)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(UpdateMap, SameBitsForAnyNumberOfThreads) {
  const BentBlock block = bentBlock(true);
  const Points preop = placesAroundBlock(600, 50, 5);
  std::vector<Points> there;
  std::vector<std::vector<PreopPlace>> back;
  for (const int count : {1, 3}) {
    setThreads(count);
    const UpdateMap map(block.mesh, block.displacements, randomMotion(5));
    there.push_back(map.scanFromPreop(preop));
    back.push_back(map.preopFromScan(there.back()));
  }
  setThreads(0);
  EXPECT_EQ(there[0], there[1]);
  for (std::size_t i = 0; i < back[0].size(); ++i) EXPECT_EQ(back[0][i].preop, back[1][i].preop);
}

}  // namespace
}  // namespace falciform::test
