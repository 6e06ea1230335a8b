#include "Logic/Deformation/Cohort/LabelPermutation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

/// Sum of the values that are labelled 0.
std::function<double(const std::vector<int>&)> sumOfLabelled(std::vector<double> values) {
  return [values](const std::vector<int>& labels) {
    double sum = 0;
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] == 0) sum += values[i];
    return sum;
  };
}

TEST(LabelPermutation, CountsArrangements) {
  EXPECT_EQ(labelArrangements({0, 0, -1, -1}), 6);
  EXPECT_EQ(labelArrangements({0, 0, 0, 1, 1, 2, 2, 2, -1, -1}), 25200);  // 10! / (3! 2! 3! 2!), thesis
  EXPECT_EQ(labelArrangements({5, 5, 5}), 1);
  EXPECT_EQ(labelArrangements(std::vector<int>(200, 1)), 1);
  std::vector<int> many(60, 0);
  std::fill(many.begin() + 30, many.end(), 1);
  EXPECT_NEAR(labelArrangements(many) / 118264581564861424.0, 1, 1e-12);  // 60 choose 30
}

TEST(LabelPermutation, AgreesWithCountingByHand) {
  // Labelled: 5 and 3 of {5, 3, 2, -9}. Sums of two: 8, 7, -4, 5, -6, -7.
  const PermutationTest test = permuteLabels({0, 0, 1, 1}, sumOfLabelled({5, 3, 2, -9}));
  EXPECT_TRUE(test.exact);
  EXPECT_EQ(test.tried, 6);
  EXPECT_DOUBLE_EQ(test.pGreater, 1.0 / 6);
  EXPECT_DOUBLE_EQ(test.pTwoSided, 1.0 / 6);
  const PermutationTest other = permuteLabels({0, 1, 1, 0}, sumOfLabelled({5, 3, 2, -9}));  // -4
  EXPECT_DOUBLE_EQ(other.pGreater, 4.0 / 6);
  EXPECT_DOUBLE_EQ(other.pTwoSided, 6.0 / 6);
}

TEST(LabelPermutation, TriesEachArrangementOnce) {
  std::set<std::vector<int>> seen;
  const PermutationTest test = permuteLabels({2, -1, 0, 0, 2, -1}, [&](const std::vector<int>& labels) {
    seen.insert(labels);
    return 0.0;
  });
  EXPECT_EQ(seen.size(), 90u);  // 6! / (2! 2! 2!)
  EXPECT_EQ(test.tried, 90);
  EXPECT_EQ(test.pGreater, 1);
}

TEST(LabelPermutation, TiesCountWhateverTheRounding) {
  // 0.1 + 0.2 is not 0.3 in binary.
  EXPECT_DOUBLE_EQ(permuteLabels({0, 1, 1, 0}, sumOfLabelled({0.3, 0.2, 0.1, 0.0})).pGreater, 4.0 / 6);
  EXPECT_DOUBLE_EQ(permuteLabels({1, 0, 0, 1}, sumOfLabelled({0.3, 0.2, 0.1, 0.0})).pGreater, 4.0 / 6);
}

TEST(LabelPermutation, DrawnArrangementsComeNearTheExactAnswer) {
  std::vector<double> values;
  std::vector<int> labels;
  for (int i = 0; i < 16; ++i) {
    values.push_back(std::sin(3.0 * i) + (i % 2 == 0 ? 0.3 : 0));
    labels.push_back(i % 2);
  }
  const PermutationTest exact = permuteLabels(labels, sumOfLabelled(values));  // 12870 arrangements
  ASSERT_TRUE(exact.exact);
  const PermutationTest drawn =
      permuteLabels(labels, sumOfLabelled(values), {.permutations = 10000, .seed = 3});
  ASSERT_FALSE(drawn.exact);
  EXPECT_EQ(drawn.arrangements, 12870);
  EXPECT_EQ(drawn.tried, 10001);
  // Four standard deviations of a share of 10000.
  EXPECT_NEAR(drawn.pGreater, exact.pGreater, 4 * std::sqrt(exact.pGreater * (1 - exact.pGreater) / 1e4));
  EXPECT_NEAR(drawn.pTwoSided, exact.pTwoSided, 4 * std::sqrt(exact.pTwoSided * (1 - exact.pTwoSided) / 1e4));
}

TEST(LabelPermutation, DrawnArrangementsDependOnTheSeedAndNotOnTheThreads) {
  std::vector<int> labels(40, 0);
  std::fill(labels.begin() + 15, labels.end(), 1);
  std::vector<double> values;
  for (int i = 0; i < 40; ++i) values.push_back(std::cos(2.0 * i));
  const auto p = [&](int seed, int count) {
    setThreads(count);
    const PermutationTest test =
        permuteLabels(labels, sumOfLabelled(values), {.permutations = 20000, .seed = seed});
    setThreads(0);
    return test.pGreater;
  };
  EXPECT_EQ(p(1, 1), p(1, 4));
  EXPECT_NE(p(1, 1), p(2, 1));
}

TEST(LabelPermutation, ADrawnPIsNeverNought) {
  std::vector<int> labels(40, 1);
  std::vector<double> values(40, 0);
  for (std::size_t i = 0; i < 20; ++i) {
    labels[i] = 0;
    values[i] = 1;
  }
  EXPECT_DOUBLE_EQ(permuteLabels(labels, sumOfLabelled(values), {.permutations = 1000}).pGreater, 1 / 1001.0);
}

TEST(LabelPermutation, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::vector<int> labels(40, 1);
  std::fill(labels.begin(), labels.begin() + 20, 0);
  EXPECT_THROW((void)permuteLabels(labels, sumOfLabelled(std::vector<double>(40, 1)), {},
                                   Progress({}, stop.get_token())),
               Cancelled);
}

}  // namespace
}  // namespace falciform
