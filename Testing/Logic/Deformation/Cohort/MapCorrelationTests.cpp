#include "Logic/Deformation/Cohort/MapCorrelation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> kNames{"a", "b", "c", "d"};

Eigen::MatrixXd randomMaps(Index vertices, Index cases, std::uint64_t seed) {
  Draws draws(seed);
  Eigen::MatrixXd maps(vertices, cases);
  for (Index i = 0; i < vertices; ++i)
    for (Index c = 0; c < cases; ++c) maps(i, c) = draws.normal();
  return maps;
}

/// Thesis Eq. (IV.5), word by word.
double equationIV5(const VectorXd& t, const VectorXd& s) {
  double top = 0, tt = 0, ss = 0;
  for (Index i = 0; i < t.size(); ++i) {
    top += (t[i] - t.mean()) * (s[i] - s.mean());
    tt += (t[i] - t.mean()) * (t[i] - t.mean());
    ss += (s[i] - s.mean()) * (s[i] - s.mean());
  }
  return top / std::sqrt(tt * ss);
}

TEST(MapCorrelation, IsTheThesissEquationOverTheVerticesThatAllCover) {
  Eigen::MatrixXd maps = randomMaps(200, 4, 1);
  for (Index i = 0; i < 200; i += 3) maps(i, i % 4) = kNone;
  const std::vector<Index> overlap = commonCoverage(maps);
  ASSERT_EQ(overlap.size(), 133u);
  for (const Index row : overlap) EXPECT_NE(row % 3, 0);
  const Eigen::MatrixXd covered = maps(overlap, Eigen::all), c = mapCorrelation(maps, overlap, kNames);
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < 4; ++j) {
      EXPECT_NEAR(c(i, j), equationIV5(covered.col(i), covered.col(j)), 1e-13);  // 133 sums of rounding
      EXPECT_EQ(c(i, j), c(j, i));
    }
}

TEST(MapCorrelation, DoesNotDependOnScaleAndOffsetAndTurnsWithTheSign) {
  Eigen::MatrixXd maps = randomMaps(50, 3, 2);
  const std::vector<Index> all = commonCoverage(maps);
  const Eigen::MatrixXd before = mapCorrelation(maps, all, kNames);
  maps.col(0) = 7 * maps.col(0).array() + 1000;
  maps.col(2) *= -0.01;
  const Eigen::MatrixXd after = mapCorrelation(maps, all, kNames);
  EXPECT_NEAR(after(0, 1), before(0, 1), 1e-11);  // of 1000 only 1e-13 is left
  EXPECT_NEAR(after(1, 2), -before(1, 2), 1e-13);
}

TEST(MapCorrelation, OfAMapWithItselfIsOneAndWithItsOppositeMinusOne) {
  Eigen::MatrixXd maps = randomMaps(20, 3, 3);
  maps.col(1) = 2 * maps.col(0);
  maps.col(2) = -maps.col(0);
  const Eigen::MatrixXd c = mapCorrelation(maps, commonCoverage(maps), kNames);
  EXPECT_NEAR(c(0, 1), 1, 1e-14);
  EXPECT_NEAR(c(0, 2), -1, 1e-14);
  EXPECT_LE(c.cwiseAbs().maxCoeff(), 1);
}

TEST(MapCorrelation, RefusesWhatHasNoCorrelation) {
  const auto refused = [](const Eigen::MatrixXd& maps, const std::string& mention) {
    try {
      (void)mapCorrelation(maps, commonCoverage(maps), kNames);
      FAIL() << "accepted: " << mention;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(mention));
    }
  };
  Eigen::MatrixXd maps = randomMaps(10, 3, 4);
  maps.col(1).setConstant(-1.1);  // its mean is -1.1 but for rounding
  refused(maps, "case 'b'");
  maps = randomMaps(10, 3, 5);
  maps.col(2).tail(8).setConstant(kNone);
  refused(maps, "cover 2 of 10 vertices");
}

}  // namespace
}  // namespace falciform
