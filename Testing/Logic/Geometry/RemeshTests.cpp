#include "Logic/Geometry/Remesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

/// Largest distance from vertices, edge middles and face centres of `from` to the surface `to`, mm.
double oneSidedHausdorff(const Surface& from, const Surface& to) {
  const TriangleTree tree(to);
  double largest = 0;
  for (Index f = 0; f < from.triangles.rows(); ++f) {
    const Vector3d a = from.points.row(from.triangles(f, 0)), b = from.points.row(from.triangles(f, 1)),
                   c = from.points.row(from.triangles(f, 2));
    for (const Vector3d& p : {a, Vector3d((a + b) / 2), Vector3d((a + b + c) / 3)})
      largest = std::max(largest, tree.closest(p).distance);
  }
  return largest;
}

/// Share of vertices with 5, 6 or 7 neighbours.
double regularShare(const Surface& surface) {
  const Adjacency ring = neighboursOfVertices(surface.triangles, surface.size());
  Index regular = 0;
  for (int v = 0; v < surface.size(); ++v) regular += ring.count(v) >= 5 && ring.count(v) <= 7;
  return static_cast<double>(regular) / static_cast<double>(surface.size());
}

/// Mean over triangles of 4 sqrt(3) area / (sum of squared edges): 1 for an equilateral triangle.
double meanQuality(const Surface& surface) {
  double sum = 0;
  for (Index f = 0; f < surface.triangles.rows(); ++f) {
    const Vector3d a = surface.points.row(surface.triangles(f, 0)),
                   b = surface.points.row(surface.triangles(f, 1)),
                   c = surface.points.row(surface.triangles(f, 2));
    sum += 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() /
           ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm());
  }
  return sum / static_cast<double>(surface.triangles.rows());
}

/// Edges from half to three times the input's: both directions.
class RemeshBothWays : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Ratios, RemeshBothWays, testing::Values(0.5, 0.8, 1.0, 1.5, 3.0));

TEST_P(RemeshBothWays, GivesACloseIsotropicManifold) {
  const Surface body = test::lumpyBody(5);
  const double input = meanEdgeLength(body), aim = GetParam() * input;
  const Surface remeshed = remeshIsotropic(body, aim);

  const TopologyReport report = inspectTopology(remeshed);
  EXPECT_TRUE(report.closedManifold()) << describeTopology(report);
  EXPECT_EQ(report.eulerCharacteristic, 2);
  EXPECT_EQ(report.unusedPoints, 0);
  EXPECT_NEAR(meanEdgeLength(remeshed) / aim, 1, 0.1);
  EXPECT_GT(regularShare(remeshed), 0.95) << "of the vertices have 5 to 7 neighbours";
  EXPECT_GT(meanQuality(remeshed), 0.9);
  // A chord of length h on a sphere of radius r leaves it by h^2 / (8 r): the body's sharpest bumps have r of
  // a few mm.
  const double gap = std::max(aim, input) * std::max(aim, input) / 8 / 4 + 0.02;
  EXPECT_LT(oneSidedHausdorff(remeshed, body), gap) << "mm";
  EXPECT_LT(oneSidedHausdorff(body, remeshed), gap) << "mm";
  EXPECT_NEAR(signedVolume(remeshed) / signedVolume(body), 1, 0.01);
  RecordProperty("hausdorff", std::to_string(oneSidedHausdorff(body, remeshed)));
}

TEST(Remesh, VerticesLieOnTheInput) {
  const Surface body = test::lumpyBody(4);
  const Surface remeshed = remeshIsotropic(body, 1.7 * meanEdgeLength(body));
  const TriangleTree tree(body);
  Index off = 0;
  for (Index i = 0; i < remeshed.size(); ++i) off += tree.closest(remeshed.points.row(i)).distance > 1e-9;
  EXPECT_LT(off, remeshed.size() / 100) << "only where a move would have folded a face";
}

TEST(Remesh, SharpRidgesAreNotWornAway) {
  const Surface box = test::box({40, 30, 20});
  for (const double aim : {1.5, 4.0}) {
    const Surface remeshed = remeshIsotropic(box, aim);
    EXPECT_TRUE(inspectTopology(remeshed).closedManifold());
    EXPECT_NEAR(signedVolume(remeshed) / 24000, 1, 1.5e-3) << "slip off the edges in six passes";
    EXPECT_NEAR(area(remeshed) / 5200, 1, 6e-3);
    EXPECT_NEAR(meanEdgeLength(remeshed) / aim, 1, 0.1);
    EXPECT_LT(oneSidedHausdorff(box, remeshed), 0.2 * aim) << "mm; corners and edges included";
  }
}

TEST(Remesh, ATorusKeepsItsHandle) {
  const Surface torus = test::torus(30, 10, 40, 20);
  for (const double aim : {1.5, 6.0}) {
    const Surface remeshed = remeshIsotropic(torus, aim);
    EXPECT_EQ(describeTopology(inspectTopology(remeshed)), "closed manifold, 1 piece, genus 1");
    EXPECT_NEAR(meanEdgeLength(remeshed) / aim, 1, 0.1);
  }
}

TEST(Remesh, FarTooCoarseAnAimStillGivesAClosedManifold) {
  for (const Surface& surface : {test::torus(30, 10, 40, 20), test::sphere(10, 3), test::box({1, 1, 1})}) {
    const TopologyReport before = inspectTopology(surface);
    const TopologyReport report = inspectTopology(remeshIsotropic(surface, 200));
    EXPECT_TRUE(report.closedManifold()) << describeTopology(report);
    EXPECT_EQ(report.eulerCharacteristic, before.eulerCharacteristic);
  }
}

TEST(Remesh, KeepsTheBoundaryOfAnOpenSurfaceInPlace) {
  const Surface sheet = test::grid(20, 10);
  const Surface remeshed = remeshIsotropic(sheet, 0.8);
  const TopologyReport report = inspectTopology(remeshed);
  EXPECT_EQ(report.nonManifoldEdges + report.flippedEdges + report.nonManifoldVertices, 0);
  EXPECT_EQ(report.eulerCharacteristic, 1);
  EXPECT_NEAR(area(remeshed), 400, 1e-9);
  EXPECT_NEAR(meanEdgeLength(remeshed) / 0.8, 1, 0.15) << "the boundary is cut, never shortened";
}

TEST(Remesh, IsDeterministicAndIndependentOfThreads) {
  const Surface body = test::lumpyBody(4);
  setThreads(1);
  const Surface one = remeshIsotropic(body, 3);
  setThreads(3);
  const Surface three = remeshIsotropic(body, 3);
  setThreads(0);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
}

TEST(Remesh, KeepsTheFrameAndDropsOtherPointData) {
  Surface body = test::lumpyBody(4);
  body.frame = "scanner";
  body.patch.assign(static_cast<std::size_t>(body.size()), 1);
  const Surface remeshed = remeshIsotropic(body, 4);
  EXPECT_EQ(remeshed.frame, "scanner");
  EXPECT_TRUE(remeshed.patch.empty());
  checkSurface(remeshed, "remeshed");
}

TEST(Remesh, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)remeshIsotropic(test::sphere(10, 3), 1, 6, Progress({}, stop.get_token())), Cancelled);
}

TEST(Remesh, RefusesWhatItCannotDo) {
  const Surface body = test::sphere(100, 3);
  EXPECT_THROW((void)remeshIsotropic(body, 0), InputError);
  EXPECT_THROW((void)remeshIsotropic(body, std::nan("")), InputError);
  EXPECT_THROW((void)remeshIsotropic(body, 1e-4), InputError) << "30 million million triangles";
  Surface turned = body;
  std::swap(turned.triangles(5, 0), turned.triangles(5, 1));
  EXPECT_THROW((void)remeshIsotropic(turned, 5), InputError);
  EXPECT_THROW((void)remeshIsotropic(Surface{}, 5), InputError);
}

}  // namespace
}  // namespace falciform
