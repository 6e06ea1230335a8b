#include <gmock/gmock.h>

#include "Logic/Atlas/DeformedMesh.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/BentBlock.h"

namespace falciform::test {
namespace {

class DeformedMeshOf : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(LinearAndQuadratic, DeformedMeshOf, testing::Bool());

TEST_P(DeformedMeshOf, TissueIsFoundWhereItsShapeFunctionsPutIt) {
  const BentBlock block = bentBlock(GetParam());
  const DeformedMesh deformed(block.mesh, block.displacements);
  const Points before = placesAroundBlock(3000, 0, 1);
  // The way there by other code: MeshPlaces' weights.
  const MeshPlaces places(block.mesh, before);
  const Points now = before + Points(places.interpolate(block.displacements));
  for (Index i = 0; i < before.rows(); ++i) {
    const auto tissue = deformed.find(now.row(i).transpose());
    ASSERT_TRUE(tissue) << i;
    // mm: the Newton steps stop at 1e-10.
    EXPECT_LT((tissue->before - before.row(i).transpose()).norm(), 1e-8);
    EXPECT_LT((deformed.now(tissue->element, tissue->barycentric) - now.row(i).transpose()).norm(), 1e-9);
  }
}

TEST_P(DeformedMeshOf, AGuessChangesNothing) {
  const BentBlock block = bentBlock(GetParam());
  const DeformedMesh deformed(block.mesh, block.displacements);
  const Points places = placesAroundBlock(400, 10, 2);
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector3d now = places.row(i).transpose();
    const auto plain = deformed.find(now),
               guessed = deformed.find(now, static_cast<int>(7 * i) % deformed.size());
    ASSERT_EQ(plain.has_value(), guessed.has_value());
    if (!plain) continue;
    EXPECT_LT((plain->before - guessed->before).norm(), 1e-8);
  }
}

TEST_P(DeformedMeshOf, AnAffineMotionIsUndoneByItsInverse) {
  BentBlock block = bentBlock(GetParam());
  Matrix3d a;
  a << 1.2, 0.3, 0, -0.2, 0.9, 0.1, 0, 0.4, 1.1;
  const Vector3d shift(30, -20, 5);
  block.displacements = (block.mesh.points * a.transpose()).rowwise() + shift.transpose() - block.mesh.points;
  const DeformedMesh deformed(block.mesh, block.displacements);
  int inside = 0;
  const Points before = placesAroundBlock(500, 20, 3);
  for (Index i = 0; i < before.rows(); ++i) {
    const Vector3d place = before.row(i).transpose();
    const bool in = (place.array() > 0).all() && (place.array() < Eigen::Array3d(120, 80, 50)).all();
    const auto tissue = deformed.find(a * place + shift);
    ASSERT_EQ(tissue.has_value(), in) << place.transpose();
    if (!tissue) continue;
    ++inside;
    EXPECT_LT((tissue->before - place).norm(), 1e-9);
  }
  EXPECT_GT(inside, 100);
}

TEST_P(DeformedMeshOf, BoxesHoldTheirElements) {
  const BentBlock block = bentBlock(GetParam(), 30);
  const DeformedMesh deformed(block.mesh, block.displacements);
  Draws draws(4);
  for (int e = 0; e < deformed.size(); ++e)
    for (int i = 0; i < 20; ++i) {
      Eigen::Vector4d b(draws.uniform(), draws.uniform(), draws.uniform(), draws.uniform());
      const Vector3d now = deformed.now(e, b / b.sum());
      EXPECT_TRUE((now.array() >= deformed.lowest(e).array()).all());
      EXPECT_TRUE((now.array() <= deformed.highest(e).array()).all());
    }
}

TEST(DeformedMesh, AnElementPressedFlatIsNoHole) {
  BentBlock block = bentBlock(false, 0);
  // All nodes into the plane z = 0: no volume, no inverse, no crash.
  block.displacements.col(2) = -block.mesh.points.col(2);
  const DeformedMesh deformed(block.mesh, block.displacements);
  EXPECT_FALSE(deformed.find(Vector3d(60, 40, 25)));
}

TEST(DeformedMesh, DisplacementsOfAnotherMeshAreRefused) {
  const BentBlock block = bentBlock(false);
  EXPECT_THROW(DeformedMesh(block.mesh, Points::Zero(3, 3)), InputError);
}

}  // namespace
}  // namespace falciform::test
