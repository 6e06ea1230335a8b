#include "Logic/Geometry/PlaneSection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

double length(const Points& section) {
  double sum = 0;
  for (Index s = 0; s < section.rows() / 2; ++s) sum += (section.row(2 * s + 1) - section.row(2 * s)).norm();
  return sum;
}

TEST(PlaneSection, OfASphereIsACircleOfPythagorasRadius) {
  const Surface ball = sphere(50, 5);
  for (const int axis : {0, 1, 2})
    for (const double at : {-40.0, 0.0, 13.7, 30.0}) {
      const double radius = std::sqrt(50 * 50 - at * at);
      const Points section = planeSection(ball, axis, at);
      for (Index i = 0; i < section.rows(); ++i) {
        EXPECT_NEAR(section(i, axis), at, 1e-9);
        EXPECT_NEAR(section.row(i).norm(), 50, 0.05) << "mm; edges of 1.7 mm lie this deep in the sphere";
      }
      EXPECT_NEAR(length(section), 2 * std::numbers::pi * radius, 0.01 * radius);
    }
}

TEST(PlaneSection, OfAClosedSurfaceIsClosedAlsoThroughItsVertices) {
  const Surface body = lumpyBody(4);
  for (const double at : {body.points(17, 2), body.points(200, 2), 0.0, 3.3}) {
    std::map<std::array<double, 3>, int> degree;
    const Points section = planeSection(body, 2, at);
    ASSERT_GT(section.rows(), 0);
    for (Index i = 0; i < section.rows(); ++i) ++degree[{section(i, 0), section(i, 1), section(i, 2)}];
    for (const auto& [place, count] : degree) EXPECT_EQ(count % 2, 0) << "an end that hangs loose";
  }
}

TEST(PlaneSection, BesideTheSurfaceThereIsNothing) {
  EXPECT_EQ(planeSection(sphere(50, 3), 1, 51).rows(), 0);
  EXPECT_EQ(planeSection(Surface{}, 1, 0).rows(), 0);
}

}  // namespace
}  // namespace falciform::test
