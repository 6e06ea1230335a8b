#include "Logic/Geometry/KdTree.h"

#include <gtest/gtest.h>

#include <flann/flann.hpp>
#include <random>
#include <set>

namespace falciform {
namespace {

Points uniform(int count, unsigned seed, double extent = 100) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-extent, extent);
  Points points(count, 3);
  for (Index i = 0; i < points.size(); ++i) points.data()[i] = coordinate(random);
  return points;
}

/// Whole coordinates: nearly every query has ties.
Points lattice(int side) {
  Points points(side * side * side, 3);
  for (int i = 0; i < points.rows(); ++i) points.row(i) << i % side, i / side % side, i / side / side;
  return points;
}

Neighbour bruteForce(const Points& points, const Vector3d& query) {
  Neighbour best;
  for (Index i = 0; i < points.rows(); ++i) {
    const double squared = squaredDistance(query, points.row(i).transpose());
    if (squared < best.squaredDistance) best = {static_cast<int>(i), squared};
  }
  return best;
}

TEST(KdTree, EqualsBruteForceBitForBit) {
  for (const int count : {1, 2, 7, 9, 100, 3000, 20'000}) {
    const Points points = uniform(count, 1);
    const KdTree tree(points);
    const Points queries = uniform(500, 2, 150);
    for (Index q = 0; q < queries.rows(); ++q) {
      const Neighbour expected = bruteForce(points, queries.row(q).transpose());
      const Neighbour found = tree.nearest(queries.row(q).transpose());
      ASSERT_EQ(found.index, expected.index);
      ASSERT_EQ(found.squaredDistance, expected.squaredDistance);
    }
  }
}

TEST(KdTree, GivesTiesToTheLowestIndex) {
  const Points points = lattice(9);
  const KdTree tree(points);
  for (double x = -0.5; x < 9; x += 0.5)
    for (double y = -0.5; y < 9; y += 0.5)
      for (double z = -0.5; z < 9; z += 0.5)
        ASSERT_EQ(tree.nearest(Vector3d(x, y, z)).index, bruteForce(points, {x, y, z}).index)
            << x << ' ' << y << ' ' << z;
}

TEST(KdTree, SurvivesAllPointsAlike) {
  const Points points = Points::Constant(200, 3, 4.0);
  const KdTree tree(points);
  EXPECT_EQ(tree.nearest(Vector3d(1, 2, 3)).index, 0);
  EXPECT_EQ(tree.within(Vector3d(4, 4, 4), 0).size(), 200u);
}

TEST(KdTree, BoundIsExclusive) {
  Points points(1, 3);
  points << 3, 0, 0;
  const KdTree tree(points);
  EXPECT_EQ(tree.nearest(Vector3d::Zero(), 9.0).index, -1);
  EXPECT_EQ(tree.nearest(Vector3d::Zero(), std::nextafter(9.0, 10.0)).index, 0);
}

TEST(KdTree, AGuessNeverChangesTheAnswer) {
  const Points points = lattice(8);
  const KdTree tree(points);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> any(0, static_cast<int>(points.rows()) - 1), half(-2, 18);
  for (int trial = 0; trial < 5000; ++trial) {
    const Vector3d query = 0.5 * Vector3d(half(random), half(random), half(random));
    const int guess = any(random);
    const Neighbour found =
        tree.nearest(query, Neighbour{guess, squaredDistance(query, points.row(guess).transpose())});
    ASSERT_EQ(found.index, bruteForce(points, query).index);
  }
}

TEST(KdTree, SubsetAnswersWithRowsOfTheWhole) {
  const Points points = uniform(400, 3);
  std::vector<int> odd;
  for (int i = 1; i < 400; i += 2) odd.push_back(i);
  const KdTree tree(points, odd);
  for (const int i : odd) ASSERT_EQ(tree.nearest(points.row(i).transpose()).index, i);
}

TEST(KdTree, KNearestAndRadiusEqualBruteForce) {
  const Points points = lattice(7);
  const KdTree tree(points);
  for (const Vector3d& query : {Vector3d(3, 3, 3), Vector3d(0.5, 2.5, 6.5), Vector3d(-4, 9, 3)}) {
    std::vector<std::pair<double, int>> all;
    for (int i = 0; i < points.rows(); ++i)
      all.emplace_back(squaredDistance(query, points.row(i).transpose()), i);
    std::vector<int> ball;
    for (const auto& [squared, i] : all)
      if (squared <= 4) ball.push_back(i);
    EXPECT_EQ(tree.within(query, 2.0), ball);
    std::sort(all.begin(), all.end());
    const std::vector<Neighbour> found = tree.nearest(query, 40);
    ASSERT_EQ(found.size(), 40u);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].index, all[i].second) << i;
  }
  EXPECT_EQ(tree.nearest(Vector3d(0, 0, 0), 1000).size(), 343u);
}

TEST(KdTree, SpaceOrderNamesEveryPointOnceAndNeighboursTogether) {
  for (const int count : {1, 8, 9, 17, 5000}) {
    const Points points = uniform(count, 6);
    const std::vector<int> order = KdTree(points).inSpaceOrder();
    EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), static_cast<std::size_t>(count));
    ASSERT_EQ(order.size(), static_cast<std::size_t>(count));
    if (count < 100) continue;
    double together = 0, listed = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
      together += (points.row(order[k]) - points.row(order[k - 1])).norm();
      listed += (points.row(static_cast<Index>(k)) - points.row(static_cast<Index>(k) - 1)).norm();
    }
    EXPECT_LT(together, 0.25 * listed);
  }
  EXPECT_TRUE(KdTree().inSpaceOrder().empty());
}

TEST(KdTree, AnEmptyTreeFindsNothing) {
  const KdTree tree(Points(0, 3));
  EXPECT_EQ(tree.nearest(Vector3d::Zero()).index, -1);
  EXPECT_TRUE(tree.nearest(Vector3d::Zero(), 3).empty());
  EXPECT_TRUE(tree.within(Vector3d::Zero(), 1).empty());
}

TEST(KdTree, AgreesWithFlann) {
  Points points = uniform(5000, 7), queries = uniform(1000, 8);
  const KdTree tree(points);
  flann::Index<flann::L2_Simple<double>> peer(flann::Matrix<double>(points.data(), 5000, 3),
                                              flann::KDTreeSingleIndexParams(10));
  peer.buildIndex();
  std::vector<int> ids(1000);
  std::vector<double> distances(1000);
  flann::Matrix<int> idMatrix(ids.data(), 1000, 1);
  flann::Matrix<double> distanceMatrix(distances.data(), 1000, 1);
  peer.knnSearch(flann::Matrix<double>(queries.data(), 1000, 3), idMatrix, distanceMatrix, 1,
                 flann::SearchParams(-1));
  for (Index q = 0; q < 1000; ++q)  // random coordinates: no ties
    EXPECT_EQ(tree.nearest(queries.row(q).transpose()).index, ids[static_cast<std::size_t>(q)]);
}

}  // namespace
}  // namespace falciform
