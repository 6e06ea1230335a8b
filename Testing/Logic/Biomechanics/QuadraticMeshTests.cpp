#include "Logic/Biomechanics/QuadraticMesh.h"

#include <gtest/gtest.h>

#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Tetrahedra.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

constexpr int kEdges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};  // VTK's order

TEST(QuadraticMesh, HasOneNodeInTheMiddleOfEachEdge) {
  const TetrahedralMesh linear = tetrahedralise(test::lumpyBody(2), 20000);
  const TetrahedralMesh mesh = quadraticMesh(linear);
  ASSERT_TRUE(mesh.quadratic());
  EXPECT_TRUE(mesh.points.topRows(linear.nodes()) == linear.points);
  EXPECT_TRUE(mesh.elements.leftCols(4) == linear.elements);
  std::set<std::pair<int, int>> edges;
  for (Index e = 0; e < mesh.size(); ++e)
    for (int k = 0; k < 6; ++k) {
      const int a = mesh.elements(e, kEdges[k][0]), b = mesh.elements(e, kEdges[k][1]);
      edges.insert(std::minmax(a, b));
      const Eigen::RowVector3d middle = (mesh.points.row(a) + mesh.points.row(b)) / 2;
      EXPECT_EQ(mesh.points.row(mesh.elements(e, 4 + k)), middle);
    }
  EXPECT_EQ(mesh.nodes(), linear.nodes() + std::ssize(edges));  // none twice, none left over
}

TEST(QuadraticMesh, KeepsRegionsAndFrameAndIsUndoneByLinearMesh) {
  TetrahedralMesh linear = tetrahedralise(test::lumpyBody(2), 20000);
  linear.frame = "tracker";
  for (Index e = 0; e < linear.size(); ++e) linear.regions.push_back(static_cast<int>(e % 3));
  const TetrahedralMesh mesh = quadraticMesh(linear);
  EXPECT_EQ(mesh.regions, linear.regions);
  EXPECT_EQ(mesh.frame, "tracker");
  const TetrahedralMesh back = linearMesh(mesh);
  EXPECT_TRUE(back.points == linear.points && back.elements == linear.elements);
  EXPECT_EQ(back.regions, linear.regions);
  EXPECT_TRUE(quadraticMesh(mesh).elements == mesh.elements);
}

TEST(QuadraticMesh, RefusesInvertedElements) {
  TetrahedralMesh mesh = tetrahedralise(test::box({1, 1, 1}));
  std::swap(mesh.elements(0, 0), mesh.elements(0, 1));
  EXPECT_THROW((void)quadraticMesh(mesh), InputError);
}

}  // namespace
}  // namespace falciform
