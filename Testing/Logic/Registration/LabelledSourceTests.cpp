#include "Logic/Registration/LabelledSource.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace falciform {
namespace {

TEST(LabelledSource, RandomRowsAreDistinctInOrderAndGrowByOne) {
  // The rows with the smallest of one fixed key each: one more row adds one to those there were.
  for (const Index rows : {2, 10, 150, 5000}) {
    std::vector<int> before;
    for (Index count = 0; count <= rows; count += std::max<Index>(1, rows / 150)) {
      const std::vector<int> drawn = randomRows(rows, count);
      ASSERT_EQ(static_cast<Index>(drawn.size()), count) << rows;
      ASSERT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
      ASSERT_EQ(std::adjacent_find(drawn.begin(), drawn.end()), drawn.end());
      ASSERT_TRUE(std::includes(drawn.begin(), drawn.end(), before.begin(), before.end()))
          << rows << ' ' << count;
      before = drawn;
    }
  }
  EXPECT_THAT(randomRows(3, 7), testing::ElementsAre(0, 1, 2));
}

TEST(LabelledSource, RandomRowsAreSpreadEvenly) {
  const std::vector<int> drawn = randomRows(10000, 1000);
  std::vector<int> tenths(10, 0);
  for (const int row : drawn) ++tenths[static_cast<std::size_t>(row / 1000)];
  for (const int count : tenths) EXPECT_NEAR(count, 100, 40);  // four standard deviations
}

TEST(LabelledSource, CentroidsAreOfEachLabelAndOfNoneWithoutLabels) {
  Points points(4, 3);
  points << 1, 0, 0, 3, 0, 0, 0, 5, 1, 9, 9, 9;
  const auto centroids = centroidsByLabel(points, {2, 2, 7, 0});
  ASSERT_EQ(centroids.size(), 2u);
  EXPECT_EQ(centroids.at(2), Vector3d(2, 0, 0));
  EXPECT_EQ(centroids.at(7), Vector3d(0, 5, 1));
  EXPECT_TRUE(centroidsByLabel(points, {}).empty());
}

}  // namespace
}  // namespace falciform
