#include "Logic/Acquisition/ScanCleaning.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "Logic/Acquisition/ScanFacing.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/ScannerSide.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using namespace test;

enum class Form { Mesh, Cloud };
enum class Shape { Plane, Dome };

/// A raster of `cells` x `cells` at 1 mm with normal noise of 0.3 mm along z, and a share of points moved
/// along z by 5 to 60 mm.
struct NoisyScan {
  Surface scan;
  std::vector<char> outlier;
};

NoisyScan noisyScan(Shape shape, Form form, double share, unsigned seed) {
  constexpr int kCells = 150;
  constexpr double kRadius = 110;  // mm: the dome's rim is 43 degrees steep, at its corners 74
  NoisyScan made{grid(kCells, kCells), {}};
  Draws draws(seed, 5);
  for (Index i = 0; i < made.scan.size(); ++i) {
    auto p = made.scan.points.row(i);
    if (shape == Shape::Dome) {
      const double r2 = (p.head<2>().array() - kCells / 2.0).square().sum();
      p[2] = std::sqrt(kRadius * kRadius - r2);
    }
    p[2] += 0.3 * draws.normal();
    const bool outlier = draws.uniform() < share;
    if (outlier) p[2] += draws.uniform(5, 60) * (draws.uniform() < 0.5 ? -1 : 1);
    made.outlier.push_back(outlier);
  }
  if (form == Form::Cloud) made.scan.triangles.resize(0, 3);
  return made;
}

struct Shares {
  double removed = 0, kept = 0;  ///< of the outliers, and of the good points
};

Shares sharesOf(const std::vector<char>& marked, const std::vector<char>& truth) {
  double outliers = 0, removed = 0, good = 0, kept = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (truth[i]) {
      ++outliers;
      removed += marked[i] != 0;
    } else {
      ++good;
      kept += marked[i] == 0;
    }
  return {outliers > 0 ? removed / outliers : 1, good > 0 ? kept / good : 1};
}

class Outliers : public testing::TestWithParam<std::tuple<Shape, Form>> {};

TEST_P(Outliers, AreFoundAndGoodPointsAreLeft) {
  const auto [shape, form] = GetParam();
  const NoisyScan made = noisyScan(shape, form, 0.02, 3);
  const FalseReturns found = findFalseReturns(made.scan, scanNeighbours(made.scan), Vector3d::UnitZ(),
                                              {.grazingDeg = 90, .smallestPieceShare = 0});
  const Shares shares = sharesOf(found.outlier, made.outlier);
  // 5 mm is 17 standard deviations off the plane; where outliers are neighbours, one may stand for the other.
  EXPECT_GT(shares.removed, 0.98);
  EXPECT_GT(shares.kept, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Scans, Outliers,
                         testing::Combine(testing::Values(Shape::Plane, Shape::Dome),
                                          testing::Values(Form::Mesh, Form::Cloud)));

TEST(FalseReturnsOf, NothingIsFoundInACleanSheet) {
  for (const Form form : {Form::Mesh, Form::Cloud}) {
    const NoisyScan made = noisyScan(Shape::Plane, form, 0, 4);
    const FalseReturns found = findFalseReturns(made.scan, scanNeighbours(made.scan), Vector3d::UnitZ(), {});
    // Beyond 5 standard deviations lie 6 of 10 million; the border's planes lean a little more.
    EXPECT_LE(std::count(found.outlier.begin(), found.outlier.end(), 1), 4);
    EXPECT_EQ(std::count(found.smallPiece.begin(), found.smallPiece.end(), 1), 0);
  }
}

TEST(FalseReturnsOf, PointsCutOffByJumpsAreOutliers) {
  Surface scan = grid(20, 20);
  scan.points.conservativeResize(scan.size() + 1, 3);
  scan.points.bottomRows(1) << 10, 10, 0.01;  // near, and in no triangle
  const FalseReturns found = findFalseReturns(scan, scanNeighbours(scan), Vector3d::UnitZ(), {});
  EXPECT_EQ(found.outlier.back(), 1);
  EXPECT_EQ(std::count(found.outlier.begin(), found.outlier.end(), 1), 1);
}

TEST(FalseReturnsOf, TheGrazingRimOfASphereIsFoundWhereItTurnsAway) {
  const Surface ball = sphere(50, 5);
  const FalseReturns found =
      findFalseReturns(ball, scanNeighbours(ball), Vector3d::UnitZ(), {.outlierSpread = 0, .grazingDeg = 70});
  for (Index i = 0; i < ball.size(); ++i) {
    const double turnedDeg =
        std::acos(std::clamp(ball.points(i, 2) / 50, -1.0, 1.0)) * 180 / std::numbers::pi;
    if (std::abs(turnedDeg - 70) < 1) continue;  // deg: the facets are 2 degrees wide
    EXPECT_EQ(found.grazing[static_cast<std::size_t>(i)] != 0, turnedDeg > 70) << turnedDeg;
  }
}

TEST(FalseReturnsOf, PiecesBelowTheirShareOfTheLargestAreFound) {
  Surface scan = grid(100, 50);
  const Surface speck = grid(8, 4), patch = grid(40, 20);
  for (const auto& [part, z] : {std::pair(&speck, 30.0), {&patch, -30.0}}) {
    const Index points = scan.size(), triangles = scan.triangles.rows();
    scan.points.conservativeResize(points + part->size(), 3);
    scan.points.bottomRows(part->size()) = part->points;
    scan.points.bottomRows(part->size()).col(2).array() += z;
    scan.triangles.conservativeResize(triangles + part->triangles.rows(), 3);
    scan.triangles.bottomRows(part->triangles.rows()) = part->triangles.array() + static_cast<int>(points);
  }
  // Shares of the area: 0.64 % and 16 %.
  const FalseReturns found = findFalseReturns(scan, scanNeighbours(scan), Vector3d::UnitZ(),
                                              {.outlierSpread = 0, .smallestPieceShare = 0.02});
  EXPECT_EQ(std::count(found.smallPiece.begin(), found.smallPiece.end(), 1), speck.size());
}

TEST(ScanFacing, TellsTheSideOfMeshesAndCloudsAndTurnsThemTo) {
  NoisyScan made = noisyScan(Shape::Dome, Form::Mesh, 0, 6);
  EXPECT_GT(seenFrom(made.scan).z(), 0.99);
  made.scan.triangles.col(1).swap(made.scan.triangles.col(2));
  EXPECT_LT(seenFrom(made.scan).z(), -0.99);
  faceTowards(made.scan, Vector3d::UnitZ());
  EXPECT_GT(seenFrom(made.scan).z(), 0.99);
  made.scan.triangles.resize(0, 3);
  EXPECT_GT(seenFrom(made.scan).z(), 0.99) << "a cloud bulges towards its scanner";
  giveNormals(made.scan, Vector3d::UnitZ());
  const Index middle = made.scan.size() / 2;
  EXPECT_GT(made.scan.normals(middle, 2), 0.9);
  EXPECT_GT(made.scan.normals.col(2).minCoeff(), 0);
}

}  // namespace
}  // namespace falciform
