#include <gtest/gtest.h>

#include "Testing/Verification/Cantilever.h"
#include "Testing/Verification/PackedBlock.h"
#include "Testing/Verification/PatchTest.h"
#include "Testing/Verification/SlidingBed.h"
#include "Testing/Verification/SmoothField.h"
#include "Testing/Verification/ThickSphere.h"

namespace falciform::verification {
namespace {

class Elements : public ::testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] static bool quadratic() { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(Orders, Elements, ::testing::Bool(),
                         [](const auto& order) { return order.param ? "Quadratic" : "Linear"; });

TEST_P(Elements, CarryAConstantStrainToRounding) {
  EXPECT_LT(patchTestError(quadratic()), 1e-10);  // of the largest displacement
}

TEST_P(Elements, ConvergeAtTheirOrderToASmoothField) {
  const Material material{.youngsModulusMPa = 0.015, .poissonsRatio = 0.3};
  const int coarse = quadratic() ? 4 : 6, fine = 2 * coarse;
  const FieldError first = smoothFieldError(material, quadratic(), coarse),
                   second = smoothFieldError(material, quadratic(), fine);
  const double order = quadratic() ? 3 : 2;
  // Within 0.2 of the order of theory, which holds as h goes to 0; these meshes are shaken and of finite h.
  EXPECT_NEAR(observedOrder(first.displacement, second.displacement, coarse, fine), order, 0.2);
  EXPECT_NEAR(observedOrder(first.energy, second.energy, coarse, fine), order - 1, 0.2);
}

TEST(Cantilever, SagsAsTimoshenkosBeam) {
  for (const CantileverLoad load : {CantileverLoad::OwnWeight, CantileverLoad::EndShear}) {
    const auto byBeam = [&](double nu, bool quadratic, int cells) {
      const HeldBody bar = cantilever(nu, quadratic, cells, load);
      return endSagMm(bar, solve(bar).displacements) / timoshenkoSagMm(nu, load);
    };
    // 0.2 %: what a beam leaves out where the clamp keeps its section from warping.
    EXPECT_NEAR(byBeam(0, true, 2), 1, 0.002);
    // 2 %: with nu above 0 the clamp also keeps it from widening.
    EXPECT_NEAR(byBeam(0.3, true, 2), 1, 0.02);
    // Displacement elements are too stiff, and less so the finer they are.
    const double coarse = byBeam(0, false, 1), middle = byBeam(0, false, 2), fine = byBeam(0, false, 4);
    EXPECT_LT(coarse, middle);
    EXPECT_LT(middle, fine);
    EXPECT_LT(fine, 1);
    // The stiffness that they have too much goes with the square of their size.
    EXPECT_NEAR(observedOrder(1 / middle - 1, 1 / fine - 1, 2, 4), 2, 0.2);
  }
}

TEST_P(Elements, SwellAThickSphereAsLame) {
  for (const double nu : {0.3, 0.47}) {
    const Material material{.youngsModulusMPa = 0.015, .poissonsRatio = nu};
    const auto errors = [&](int layers) {
      const HeldBody sphere = thickSphere(material, quadratic(), layers);
      return sphereErrors(sphere, solve(sphere).displacements);
    };
    const SphereErrors coarse = errors(4), fine = errors(8);
    const bool locks = !quadratic() && nu > 0.4;
    // Relative. Plane faces alone cost 2nd order in h, whatever the element; linear ones lock on top of that.
    EXPECT_LT(fine.worst, quadratic() ? 0.04 : (locks ? 0.3 : 0.12));
    EXPECT_LT(std::abs(fine.swell), quadratic() ? 0.04 : (locks ? 0.3 : 0.12));
    EXPECT_GT(observedOrder(std::abs(coarse.swell), std::abs(fine.swell), 4, 8), locks ? 0.7 : 1.5);
  }
}

TEST(ThickSphere, CutsBindAlongTheirOwnNormalsOnMeshesOfUnevenFaces) {
  // Where a cut meets the sphere, one of the two may have most of the area around a node.
  for (const int layers : {2, 3, 4, 5, 7}) {
    const HeldBody sphere = thickSphere(Material{}, true, layers);
    for (const NodeConstraint& constraint : sphere.constraints) {
      const Vector3d x = sphere.mesh.points.row(constraint.node).transpose();
      const Eigen::Array3d onCut = (x.array() < 1e-9).cast<double>();
      EXPECT_EQ(constraint.count, static_cast<int>(onCut.sum()));
      for (int k = 0; k < constraint.count; ++k)
        EXPECT_NEAR((constraint.frame.row(k).transpose().array() * onCut).matrix().norm(), 1, 1e-12);
    }
  }
}

TEST(Locking, LinearElementsStiffenTowardsIncompressibilityQuadraticOnesHardly) {
  for (const BlockLoad load : {BlockLoad::OwnWeight, BlockLoad::Packed}) {
    double before = 0;
    for (const double nu : {0.3, 0.45, 0.47, 0.49}) {
      const double fine = blockStiffness(packedBlock(nu, true, 25, load), load);
      const double linear = blockStiffness(packedBlock(nu, false, 50, load), load) / fine - 1;
      const double sameNodes = blockStiffness(packedBlock(nu, false, 25, load), load) / fine - 1;
      const double quadratic = blockStiffness(packedBlock(nu, true, 50, load), load) / fine - 1;
      EXPECT_GT(linear, before);
      EXPECT_GT(linear, sameNodes);
      EXPECT_GT(sameNodes, 2 * quadratic);  // quadratic elements with the same nodes: less than half the bias
      before = linear;
    }
  }
}

class Bed : public ::testing::TestWithParam<std::tuple<bool, bool>> {};
INSTANTIATE_TEST_SUITE_P(Shapes, Bed, ::testing::Combine(::testing::Bool(), ::testing::Bool()),
                         [](const auto& bed) {
                           return std::string(std::get<0>(bed.param) ? "Quadratic" : "Linear") +
                                  (std::get<1>(bed.param) ? "Curved" : "Plane");
                         });

TEST_P(Bed, HoldsAlongItsNormalAloneHoweverTheProblemIsTurned) {
  const BedErrors errors = bedErrors(std::get<0>(GetParam()), std::get<1>(GetParam()));
  EXPECT_LT(errors.rotated, 1e-9);           // of the largest displacement
  EXPECT_LT(errors.intoBed, 1e-15);          // one rounding: the constraint is built in, not a penalty
  EXPECT_LT(errors.tangentialForce, 1e-12);  // of the weight: the residual of the factorisation
  EXPECT_LT(errors.balance, 1e-12);          // of the weight
}

}  // namespace
}  // namespace falciform::verification
