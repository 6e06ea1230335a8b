#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Subdivision.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

TEST(Subdivision, ShapeStaysAndEdgesHalve) {
  const Surface body = lumpyBody(3), fine = subdivided(body);
  EXPECT_TRUE(inspectTopology(fine).closedManifold());
  EXPECT_EQ(fine.triangles.rows(), 4 * body.triangles.rows());
  EXPECT_NEAR(signedVolume(fine), signedVolume(body), 1e-9 * signedVolume(body));
  EXPECT_NEAR(area(fine), area(body), 1e-9 * area(body));
  EXPECT_EQ(fine.points.topRows(body.size()), body.points);
  EXPECT_NEAR(meanEdgeLength(fine) / meanEdgeLength(body), 0.5, 0.05);
}

TEST(Subdivision, PatchesKeepToTheirArea) {
  const Surface body = lumpyBody(5), fine = subdivided(body);
  for (const int label : patchLabels(body)) {
    // Inside a patch all is its own: a plane's share of four new points to an old one, less the rim's.
    EXPECT_GT(pointsOfPatch(fine, label).size(), 2 * pointsOfPatch(body, label).size());
    EXPECT_LT(pointsOfPatch(fine, label).size(), 4 * pointsOfPatch(body, label).size());
  }
}

TEST(Subdivision, GoesOnUntilEdgesAreShortEnough) {
  const Surface body = lumpyBody(2);
  EXPECT_LE(meanEdgeLength(subdividedTo(body, 3)), 3);
  EXPECT_EQ(subdividedTo(body, 1000).size(), body.size());
  EXPECT_THROW((void)subdividedTo(body, 0), InputError);
}

}  // namespace
}  // namespace falciform::test
