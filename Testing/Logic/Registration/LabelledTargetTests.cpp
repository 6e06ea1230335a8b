#include "Logic/Registration/LabelledTarget.h"

#include <gtest/gtest.h>

#include <random>

namespace falciform {
namespace {

/// Eq. (III.1) by the letter, with the erratum: only equal labels above 0 are scaled. Ties to the lowest
/// index.
int bruteForce(const Surface& surface, const Vector3d& query, int label, double weight) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < surface.size(); ++i) {
    double squared = squaredDistance(query, surface.points.row(i).transpose());
    if (label > 0 && surface.patchAt(i) == label) squared *= weight * weight;
    if (squared < least) {
      least = squared;
      best = static_cast<int>(i);
    }
  }
  return best;
}

Surface labelled(Points points, int labels, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> label(0, labels);
  Surface surface;
  surface.points = std::move(points);
  for (Index i = 0; i < surface.size(); ++i) surface.patch.push_back(label(random));
  return surface;
}

Points randomPoints(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  Points points(count, 3);
  for (Index i = 0; i < points.size(); ++i) points.data()[i] = coordinate(random);
  return points;
}

Points lattice(int side) {
  Points points(side * side * side, 3);
  for (int i = 0; i < points.rows(); ++i) points.row(i) << i % side, i / side % side, i / side / side;
  return points;
}

TEST(LabelledTarget, EqualsBruteForceOnRandomSets) {
  const Surface surface = labelled(randomPoints(800, 1), 3, 2);
  const LabelledTarget target(surface, {1, 2, 3});
  const Points queries = randomPoints(400, 3);
  for (const double weight : {1e-4, 0.1, 0.5, 0.9, 1.0})
    for (Index q = 0; q < queries.rows(); ++q)
      for (int label = 0; label <= 3; ++label) {
        const Vector3d query = queries.row(q).transpose();
        const Neighbour found = target.closest(query, label, weight);
        ASSERT_EQ(found.index, bruteForce(surface, query, label, weight))
            << "label " << label << " weight " << weight;
        ASSERT_EQ(found.squaredDistance, squaredDistance(query, surface.points.row(found.index).transpose()));
      }
}

TEST(LabelledTarget, EqualsBruteForceWhereEverythingTies) {
  // Whole and half coordinates with weights 1/2 and 1: equal scaled distances between labels are the rule
  // here.
  const Surface surface = labelled(lattice(6), 2, 5);
  const LabelledTarget target(surface, {1, 2});
  for (const double weight : {0.25, 0.5, 1.0})
    for (double x = -1; x <= 6; x += 0.5)
      for (double y = -1; y <= 6; y += 0.5)
        for (int z = -1; z <= 6; ++z)
          for (int label = 0; label <= 2; ++label)
            ASSERT_EQ(target.closest({x, y, z * 1.0}, label, weight).index,
                      bruteForce(surface, {x, y, z * 1.0}, label, weight))
                << x << ' ' << y << ' ' << z << " label " << label << " weight " << weight;
}

TEST(LabelledTarget, AnotherPointWinsOnlyWithinTheScaledRadius) {
  Surface surface;
  surface.points.resize(2, 3);
  surface.points << 10, 0, 0, 0.5, 0, 0;
  surface.patch = {1, 0};
  const LabelledTarget target(surface, {1});
  EXPECT_EQ(target.closest(Vector3d::Zero(), 1, 0.04).index, 0);  // 0.4 mm scaled against 0.5 mm
  EXPECT_EQ(target.closest(Vector3d::Zero(), 1, 0.06).index, 1);  // 0.6 mm scaled against 0.5 mm
  EXPECT_EQ(target.closest(Vector3d::Zero(), 0, 0.04).index, 1);  // no label, no bias
}

TEST(LabelledTarget, AGuessNeverChangesTheAnswer) {
  const Surface surface = labelled(lattice(5), 2, 9);
  const LabelledTarget target(surface, {1, 2});
  std::mt19937 random(4);
  std::uniform_int_distribution<int> any(0, 124), half(-2, 12), label(0, 2);
  for (int trial = 0; trial < 4000; ++trial) {
    const Vector3d query = 0.5 * Vector3d(half(random), half(random), half(random));
    const int l = label(random);
    ASSERT_EQ(target.closest(query, l, 0.5, any(random)).index, bruteForce(surface, query, l, 0.5));
  }
}

TEST(LabelledTarget, LabelsNotInUseAreNoBias) {
  const Surface surface = labelled(randomPoints(200, 1), 2, 2);
  const LabelledTarget target(surface, {1});
  const Points queries = randomPoints(50, 6);
  for (Index q = 0; q < queries.rows(); ++q)
    EXPECT_EQ(target.closest(queries.row(q).transpose(), 2, 1e-4).index,
              bruteForce(surface, queries.row(q).transpose(), 0, 1));
  EXPECT_FALSE(target.has(2));
  EXPECT_TRUE(target.has(1));
}

}  // namespace
}  // namespace falciform
