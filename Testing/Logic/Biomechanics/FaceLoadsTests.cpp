#include <gtest/gtest.h>

#include <numeric>

#include "Logic/Biomechanics/FaceLoads.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Errors.h"
#include "Testing/Support/BlockMesh.h"
#include "Testing/Verification/HeldBody.h"

namespace falciform::verification {
namespace {

const Vector3d kSize(40, 30, 20);

class FaceLoads : public ::testing::TestWithParam<bool> {
 protected:
  FaceLoads() {
    const TetrahedralMesh linear = test::shakenBlockMesh(kSize, {4, 3, 3}, 0.2, 7);
    mesh_ = GetParam() ? quadraticMesh(linear) : linear;
    faces_ = boundaryFaces(mesh_);
    all_.resize(static_cast<std::size_t>(faces_.size()));
    std::iota(all_.begin(), all_.end(), 0);
  }
  [[nodiscard]] Vector3d momentOf(const Points& forces) const {
    Vector3d sum = Vector3d::Zero();
    for (Index n = 0; n < mesh_.nodes(); ++n)
      sum += Vector3d(mesh_.points.row(n).transpose()).cross(Vector3d(forces.row(n).transpose()));
    return sum;
  }
  TetrahedralMesh mesh_;
  BoundaryFaces faces_;
  std::vector<int> all_;
};
INSTANTIATE_TEST_SUITE_P(Orders, FaceLoads, ::testing::Bool(),
                         [](const auto& order) { return order.param ? "Quadratic" : "Linear"; });

TEST_P(FaceLoads, PressureAllAroundHasNeitherForceNorMoment) {
  const Points forces = pressureForces(mesh_, faces_, all_, 2);
  EXPECT_GT(largest(forces), 1);
  EXPECT_LT(forces.colwise().sum().norm(), 1e-10);  // N, of some 10,000 N
  EXPECT_LT(momentOf(forces).norm(), 1e-8);         // N mm, of some 400,000
}

TEST_P(FaceLoads, PressureDoesTheWorkOfTheVolumeThatItSqueezesOut) {
  // Under u = x, the volume changes by 3 V: work is -3 p V.
  const Points forces = pressureForces(mesh_, faces_, all_, 2);
  EXPECT_NEAR(forces.cwiseProduct(mesh_.points).sum(), -3 * 2 * kSize.prod(), 1e-8);
}

TEST_P(FaceLoads, PressureOnOneSidePushesInwardsAtItsMiddle) {
  const auto side = facesWhere(mesh_, faces_, [](const Vector3d& x) { return x[0] < 1e-9; });
  const Points forces = pressureForces(mesh_, faces_, side, 0.5);
  const Vector3d force(0.5 * kSize[1] * kSize[2], 0, 0), middle(0, kSize[1] / 2, kSize[2] / 2);
  EXPECT_LT((forces.colwise().sum().transpose() - force).norm(), 1e-10);  // N
  EXPECT_LT((momentOf(forces) - middle.cross(force)).norm(), 1e-8);       // N mm
  const Points sheared = tractionForces(mesh_, faces_, side, {0, 0, 0.25});
  EXPECT_NEAR(sheared.col(2).sum(), 0.25 * kSize[1] * kSize[2], 1e-10);  // N
}

TEST_P(FaceLoads, FacesThatAreNotThereAreRefused) {
  EXPECT_THROW((void)pressureForces(mesh_, faces_, {static_cast<int>(faces_.size())}, 1), InputError);
  EXPECT_THROW((void)pressureForces(mesh_, faces_, {-1}, 1), InputError);
  EXPECT_THROW((void)pressureForces(mesh_, faces_, all_, std::nan("")), InputError);
}

}  // namespace
}  // namespace falciform::verification
