#include "Logic/Biomechanics/LiverMesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Crossings.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::sphere;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

MeshSettings edge(double mm) {
  MeshSettings settings;
  settings.edgeLengthMm = mm;
  return settings;
}

Surface both(const Surface& a, const Surface& b) {
  Surface all;
  all.points.resize(a.size() + b.size(), 3);
  all.points << a.points, b.points;
  all.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  all.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.size())).matrix();
  return all;
}

std::string refusalOf(const Surface& surface, const MeshSettings& settings,
                      const std::vector<Surface>& tumours = {}) {
  try {
    (void)meshLiver(surface, tumours, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A ball whose pole is pushed down and out through the other side.
Surface piercedBall() {
  Surface ball = sphere(50, 4);
  for (Index i = 0; i < ball.size(); ++i)
    if (ball.points(i, 2) > 40) ball.points(i, 2) -= 15 * (ball.points(i, 2) - 40);
  return ball;
}

/// A ball with a slit of `widthMm`, 60 mm deep, made of two walls that nearly touch.
Surface slitBall(double widthMm) {
  Surface ball = sphere(60, 6);
  for (Index i = 0; i < ball.size(); ++i) {
    const double x = ball.points(i, 0), z = ball.points(i, 2);
    if (z > 0 && std::abs(x) < 6) {
      ball.points(i, 0) = x / 6 * widthMm / 2;
      ball.points(i, 2) -= 60 * std::pow(1 - std::abs(x) / 6, 0.25) * z / 60;
    }
  }
  return ball;
}

TEST(LiverMesh, FillsTheSurfaceWithElementsOfTheWantedSize) {
  Index previous = 0;
  for (const double mm : {20.0, 12.0, 8.0}) {
    const LiverMesh made = meshLiver(lumpyBody(4), {}, edge(mm));
    ASSERT_TRUE(made.mesh.quadratic());
    EXPECT_NO_THROW(checkMesh(made.mesh, "made"));
    EXPECT_NEAR(made.report.edgeLengthMm, mm, 0.2 * mm);  // quality refinement makes them a little shorter
    EXPECT_GT(made.report.elements, previous);
    // Chords of length h cut off about h^2 / 8 R of a body of radius R = 60 mm: 3 h^2 / 8 R^2 of its volume.
    EXPECT_NEAR(made.report.volumeMm3 / made.report.inputVolumeMm3, 1, mm * mm / 3600);
    EXPECT_EQ(made.report.degreesOfFreedom, 3 * made.mesh.nodes());
    previous = made.report.elements;
  }
}

TEST(LiverMesh, HasElementsOfGoodShapeInARoundBody) {
  const MeshReport report = meshLiver(sphere(60, 4), {}, edge(12)).report;
  EXPECT_GT(report.minDihedralDeg, 5);  // deg: half of what TetGen is asked for
  EXPECT_GT(report.medianDihedralDeg, 40);
  EXPECT_GT(report.minScaledJacobian, 0.05);
  EXPECT_GT(report.minRadiusRatio, 0.02);
  EXPECT_THAT(report.warnings, IsEmpty());
  EXPECT_THAT(report.repairs, IsEmpty());
}

TEST(LiverMesh, IsTheSameEachTimeAndForAnyNumberOfThreads) {
  const std::vector<Surface> tumours{sphere(10, 2)};
  setThreads(1);
  const LiverMesh one = meshLiver(lumpyBody(4), tumours, edge(12));
  setThreads(3);
  const LiverMesh three = meshLiver(lumpyBody(4), tumours, edge(12));
  setThreads(0);
  EXPECT_TRUE(one.mesh.points == three.mesh.points && one.mesh.elements == three.mesh.elements);
  EXPECT_EQ(one.mesh.regions, three.mesh.regions);
}

TEST(LiverMesh, StaysNearTheSurfaceAndSaysHowNear) {
  const LiverMesh made = meshLiver(sphere(60, 5), {}, edge(12));
  // A chord of 12 mm in a circle of 60 mm sags by 0.30 mm, the middle of its triangle by 0.40 mm; edges of up
  // to 4/3 of that by 0.71 mm.
  EXPECT_LT(made.report.maxDistanceMm, 0.8);
  EXPECT_GT(made.report.meanDistanceMm, 0.1);
  EXPECT_LT(made.report.meanDistanceMm, 0.5);
  EXPECT_LT(made.report.maxUncoveredMm, 0.8);
}

TEST(LiverMesh, MakesTumoursRegionsWithTheirVolume) {
  const std::vector<Surface> tumours{sphere(12, 3, {15, 0, 0}), sphere(6, 3, {-15, 5, 5})};
  const LiverMesh made = meshLiver(sphere(60, 4), tumours, edge(12));
  ASSERT_EQ(made.report.regions.size(), 3U);
  for (const std::size_t k : {1U, 2U}) {
    const MeshRegion& region = made.report.regions[k];
    EXPECT_TRUE(region.conforming);
    // Conforming elements fill exactly what the remeshed surface encloses, which has the tumour's volume.
    EXPECT_NEAR(region.volumeMm3, signedVolume(tumours[k - 1]), 1e-6 * region.volumeMm3);
    EXPECT_GT(region.elements, 50);
  }
  EXPECT_THAT(made.report.warnings, IsEmpty());
}

TEST(LiverMesh, LeavesATumourAtTheSurfaceToTheElementsCentresAndSaysSo) {
  const Surface tumour = sphere(15, 3, {50, 0, 0});  // reaches out of the ball of 60 mm
  const LiverMesh made = meshLiver(sphere(60, 4), {tumour}, edge(10));
  EXPECT_FALSE(made.report.regions[1].conforming);
  EXPECT_THAT(made.report.warnings, Contains(HasSubstr("reaches the liver's surface")));
  // The part of the tumour inside the ball: two caps; 15 % for the elements that its surface cuts.
  const double d = 50, R = 60, r = 15;
  const double lens = EIGEN_PI * std::pow(R + r - d, 2) *
                      (d * d + 2 * d * r - 3 * r * r + 2 * d * R + 6 * r * R - 3 * R * R) / (12 * d);
  EXPECT_NEAR(made.report.regions[1].volumeMm3, lens, 0.15 * lens);
}

TEST(LiverMesh, SaysWhichTumoursTouch) {
  const LiverMesh made = meshLiver(sphere(60, 4), {sphere(12, 3), sphere(12, 3, {18, 0, 0})}, edge(10));
  EXPECT_TRUE(made.report.regions[1].conforming);
  EXPECT_FALSE(made.report.regions[2].conforming);
  EXPECT_THAT(made.report.warnings, Contains(HasSubstr("touches tumour 1")));
  EXPECT_GT(made.report.regions[2].elements, 20);
}

TEST(LiverMesh, RefusesATumourOutsideTheLiver) {
  EXPECT_THAT(refusalOf(sphere(60, 3), edge(15), {sphere(10, 2, {200, 0, 0})}),
              HasSubstr("outside the liver"));
}

TEST(LiverMesh, MendsASlitThatRemeshingMakesCutThroughItself) {
  const Surface slit = slitBall(0.6);
  ASSERT_TRUE(inspectTopology(slit).closedManifold());
  const LiverMesh made = meshLiver(slit, {}, edge(10));
  EXPECT_THAT(made.report.repairs, testing::Not(IsEmpty()));
  EXPECT_LT(made.report.maxDistanceMm, 5);  // mm: half the edge length, as the setting promises
  EXPECT_NEAR(made.report.volumeMm3, made.report.inputVolumeMm3, 0.05 * made.report.inputVolumeMm3);
  EXPECT_TRUE(selfCrossings(boundarySurface(made.mesh, boundaryFaces(made.mesh)).surface).empty());
}

TEST(LiverMesh, NamesTheFacetsThatItMayNotMend) {
  MeshSettings settings = edge(10);
  settings.maxRepairMm = 0.01;
  const std::string text = refusalOf(piercedBall(), settings);
  EXPECT_THAT(text, testing::ContainsRegex("cuts through itself: [0-9]+ pairs of triangles cross"));
  EXPECT_THAT(text, testing::ContainsRegex("the first [0-9]+ and [0-9]+ at .* mm"));
  EXPECT_THAT(text, HasSubstr("--max-repair"));
  EXPECT_THAT(text, testing::Not(HasSubstr("\n")));
}

TEST(LiverMesh, RefusesOpenSurfacesAndSaysWhere) {
  Surface open = sphere(60, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  EXPECT_THAT(refusalOf(open, edge(15)), HasSubstr("open: 3 edges have one triangle only, the first at"));
}

TEST(LiverMesh, RefusesPiecesUnlessAskedToKeepTheLargest) {
  const Surface two = both(sphere(60, 3), sphere(10, 2, {100, 0, 0}));
  EXPECT_THAT(refusalOf(two, edge(15)), HasSubstr("in 2 pieces"));
  MeshSettings settings = edge(15);
  settings.largestPiece = true;
  const LiverMesh made = meshLiver(two, {}, settings);
  EXPECT_NEAR(made.report.inputVolumeMm3, signedVolume(sphere(60, 3)), 1);  // mm3 of a million
  EXPECT_THAT(made.report.warnings, Contains(HasSubstr("largest of 2 pieces")));
}

TEST(LiverMesh, MendsWhatFilesDoToSurfacesAndSaysSo) {
  const Surface ball = sphere(60, 3);
  const LiverMesh expected = meshLiver(ball, {}, edge(15));
  Surface soup;  // triangle by triangle, inside out, and one triangle twice
  soup.points.resize(3 * ball.triangles.rows(), 3);
  soup.triangles.resize(ball.triangles.rows() + 1, 3);
  for (Index t = 0; t < ball.triangles.rows(); ++t)
    for (Index k = 0; k < 3; ++k) {
      soup.points.row(3 * t + k) = ball.points.row(ball.triangles(t, 2 - k));
      soup.triangles(t, k) = static_cast<int>(3 * t + k);
    }
  soup.triangles.row(ball.triangles.rows()) = soup.triangles.row(0);
  const LiverMesh made = meshLiver(soup, {}, edge(15));
  EXPECT_NEAR(made.report.volumeMm3, expected.report.volumeMm3, 0.01 * expected.report.volumeMm3);
  EXPECT_THAT(made.report.warnings, Contains(HasSubstr("double points joined")));
  EXPECT_THAT(made.report.warnings, Contains(HasSubstr("1 double triangle dropped")));
  EXPECT_THAT(made.report.warnings, Contains(HasSubstr("faced inwards")));
}

TEST(LiverMesh, RefusesBodiesTooSmallForTheEdges) {
  EXPECT_THAT(refusalOf(sphere(5, 2), edge(10)), HasSubstr("too little for edges"));
  EXPECT_THAT(refusalOf(test::grid(50, 4), edge(10)), HasSubstr("open"));
  EXPECT_THAT(refusalOf(Surface{}, edge(10)), HasSubstr("no triangles"));
}

}  // namespace
}  // namespace falciform
