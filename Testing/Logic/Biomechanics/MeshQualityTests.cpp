#include "Logic/Biomechanics/MeshQuality.h"

#include <gtest/gtest.h>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TetrahedralMesh one(const Points& corners) {
  TetrahedralMesh mesh;
  mesh.points = corners;
  mesh.elements.resize(1, 4);
  mesh.elements << 0, 1, 2, 3;
  return mesh;
}

Points regular(double edge) {
  Points corners(4, 3);
  corners << 1, 1, 1, -1, 1, -1, 1, -1, -1, -1, -1, 1;
  return corners * (edge / std::sqrt(8.0));
}

TEST(MeshQuality, OfARegularTetrahedronIsOne) {
  const ElementShape shape = shapeOf(one(regular(7)), 0);
  EXPECT_NEAR(shape.minDihedralDeg, std::acos(1.0 / 3) * 180 / EIGEN_PI, 1e-9);  // rounding of acos
  EXPECT_NEAR(shape.radiusRatio, 1, 1e-12);
  EXPECT_NEAR(shape.scaledJacobian, 1, 1e-12);
}

TEST(MeshQuality, OfACubesCornerIsKnown) {
  Points corners(4, 3);
  corners << 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2;
  const ElementShape shape = shapeOf(one(corners), 0);
  EXPECT_NEAR(shape.minDihedralDeg, std::atan(std::sqrt(2.0)) * 180 / EIGEN_PI, 1e-9);
  // Inscribed 2 / (3 + sqrt 3), circumscribed sqrt 3.
  EXPECT_NEAR(shape.radiusRatio, 3 * 2 / (3 + std::sqrt(3.0)) / std::sqrt(3.0), 1e-12);
  // Volume 6 V = 8; the longest corner product is 2 sqrt8 sqrt8 = 16.
  EXPECT_NEAR(shape.scaledJacobian, std::sqrt(2.0) * 8 / 16, 1e-12);
}

TEST(MeshQuality, DoesNotDependOnSizeOrPlaceAndVanishesForFlatOnes) {
  Points corners(4, 3);
  corners << 0, 0, 0, 3, 0.2, 0, 0.4, 2, 0.1, 1, 0.7, 1.5;
  const ElementShape shape = shapeOf(one(corners), 0);
  const Points moved = transformed(Points(17 * corners), test::randomMotion(3));
  const ElementShape other = shapeOf(one(moved), 0);
  // 1e-9: coordinates of 100 mm lose three digits.
  EXPECT_NEAR(shape.minDihedralDeg, other.minDihedralDeg, 1e-9);
  EXPECT_NEAR(shape.radiusRatio, other.radiusRatio, 1e-9);
  EXPECT_NEAR(shape.scaledJacobian, other.scaledJacobian, 1e-9);
  corners.col(2) << 0, 0, 0, 1e-6;
  const ElementShape flat = shapeOf(one(corners), 0);
  EXPECT_LT(flat.minDihedralDeg, 1e-3);
  EXPECT_LT(flat.radiusRatio, 1e-5);
  EXPECT_LT(flat.scaledJacobian, 1e-5);
}

}  // namespace
}  // namespace falciform
