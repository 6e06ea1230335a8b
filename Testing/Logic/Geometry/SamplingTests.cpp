#include "Logic/Geometry/Sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TEST(Sampling, TakesFromEachCellThePointNearestItsCentre) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-20, 20);
  Points points(3000, 3);
  for (Index i = 0; i < points.rows(); ++i)
    for (int k = 0; k < 3; ++k) points(i, k) = place(random);
  const double cell = 4.7;
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  std::map<std::array<int, 3>, std::pair<double, int>> naive;
  for (int i = 0; i < points.rows(); ++i) {
    std::array<int, 3> key{};
    double off = 0;
    for (int k = 0; k < 3; ++k) {
      const double x = (points(i, k) - low[k]) / cell;
      key[static_cast<std::size_t>(k)] = static_cast<int>(x);
      off += std::pow(x - std::floor(x) - 0.5, 2);
    }
    const auto found = naive.find(key);
    if (found == naive.end() || off < found->second.first) naive[key] = {off, i};
  }
  std::set<int> expected;
  for (const auto& [key, best] : naive) expected.insert(best.second);
  const std::vector<int> ids = voxelSample(points, cell);
  EXPECT_EQ(ids, std::vector<int>(expected.begin(), expected.end()));
}

TEST(Sampling, KeepsEveryPlaceWhenCellsAreTinyAndOneWhenTheyAreHuge) {
  const Surface s = test::sphere(50, 3);
  EXPECT_EQ(static_cast<Index>(voxelSample(s.points, 1e-9).size()), s.size());
  EXPECT_EQ(voxelSample(s.points, 1e9).size(), 1U);
  EXPECT_TRUE(voxelSample(Points(0, 3), 1).empty());
  EXPECT_EQ(voxelSample(Points::Constant(50, 3, 4.5), 1), std::vector<int>{0});
}

TEST(Sampling, SpreadsAboutTheAskedNumberEvenly) {
  const Surface s = test::sphere(80, 5);  // 10242 points
  for (const Index count : {50, 500, 3000}) {
    const std::vector<int> ids = spreadSample(s.points, count);
    EXPECT_NEAR(static_cast<double>(ids.size()), static_cast<double>(count),
                0.05 * static_cast<double>(count) + 3);
    // No point of the sphere is farther from the sample than 3 radii of an even share of the area.
    const double share = std::sqrt(4 * 80.0 * 80.0 / static_cast<double>(count));
    const Points chosen = rowsOf(s.points, ids);
    for (Index i = 0; i < s.size(); i += 37)
      EXPECT_LT((chosen.rowwise() - s.points.row(i)).rowwise().norm().minCoeff(), 3 * share);
  }
}

TEST(Sampling, GivesAllPointsWhenThereAreFewerAndNoneWhenNoneAreAsked) {
  const Points points = Points::Random(20, 3);
  EXPECT_EQ(spreadSample(points, 20).size(), 20U);
  EXPECT_EQ(spreadSample(points, 1000).back(), 19);
  EXPECT_TRUE(spreadSample(points, 0).empty());
}

}  // namespace
}  // namespace falciform
