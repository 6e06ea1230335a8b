#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"

namespace falciform::test {
namespace {

constexpr Index kNodes = 3000;  // several chunks

struct Problem {
  std::vector<Points> fields;
  Eigen::MatrixXd combinations;
  VectorXd volumes;
};

/// Fields that fall off from 10 mm by a factor of 3 each, drawn.
Problem problem(int fields, int members, unsigned seed) {
  Draws draws(seed);
  Problem p{.fields = {}, .combinations = Eigen::MatrixXd(members, fields), .volumes = VectorXd(kNodes)};
  for (Index n = 0; n < kNodes; ++n) p.volumes[n] = draws.uniform(0.1, 5);
  for (int k = 0; k < fields; ++k) {
    Points field(kNodes, 3);
    for (Index n = 0; n < kNodes; ++n) field.row(n) = 10 * std::pow(3.0, -k) * draws.normal3().transpose();
    p.fields.push_back(field);
  }
  for (int m = 0; m < members; ++m)
    for (int k = 0; k < fields; ++k) p.combinations(m, k) = draws.normal();
  return p;
}

Points memberOf(const Problem& p, Index m) { return fieldOf(p.fields, p.combinations.row(m)); }

double innerProduct(const Problem& p, const Points& a, const Points& b) {
  return a.cwiseProduct(b).rowwise().sum().dot(p.volumes) / p.volumes.sum();
}

TEST(ModeCompression, ModesAreOrthonormalOverTheVolume) {
  const Problem p = problem(12, 40, 1);
  const CompressedFields compressed = compressFields(p.fields, p.combinations, p.volumes, 1);
  ASSERT_EQ(compressed.modes.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j <= i; ++j)  // rounding, though the last mode is 5e-6 of the first
      EXPECT_NEAR(innerProduct(p, compressed.modes[i], compressed.modes[j]), i == j, 1e-12) << i << " " << j;
}

TEST(ModeCompression, SingularValuesAreThoseOfTheWeightedMembers) {
  const Problem p = problem(5, 20, 2);
  const CompressedFields compressed = compressFields(p.fields, p.combinations, p.volumes, 1);
  Eigen::MatrixXd all(3 * kNodes, 20);
  for (Index m = 0; m < 20; ++m) {
    Points weighted = memberOf(p, m);
    for (Index n = 0; n < kNodes; ++n) weighted.row(n) *= std::sqrt(p.volumes[n] / p.volumes.sum());
    all.col(m) = Eigen::Map<const VectorXd>(weighted.data(), weighted.size());
  }
  const VectorXd direct = Eigen::BDCSVD<Eigen::MatrixXd>(all).singularValues().head(5);
  // Squares are known to 1e-16 of the largest; the last is 1e-4 of it in square.
  EXPECT_LT((compressed.singularValuesMm - direct).cwiseQuotient(direct).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(ModeCompression, KeepsTheFewestModesForTheEnergyAndKnowsItsError) {
  const Problem p = problem(12, 40, 3);
  double before = 0;
  for (const double energy : {0.9, 0.999, 0.99999, 0.9999999}) {
    const CompressedFields c = compressFields(p.fields, p.combinations, p.volumes, energy);
    EXPECT_GE(c.energy, energy);
    EXPECT_GT(static_cast<double>(c.modes.size()), before);
    before = static_cast<double>(c.modes.size());
    const VectorXd squares = c.singularValuesMm.cwiseAbs2();
    EXPECT_LT(squares.head(static_cast<Index>(c.modes.size()) - 1).sum(), energy * squares.sum());
    double left = 0, total = 0;
    for (Index m = 0; m < 40; ++m) {
      const Points member = memberOf(p, m);
      const Points rest = member - fieldOf(c.modes, c.coefficients.row(m));
      const double error = std::sqrt(innerProduct(p, rest, rest));
      EXPECT_NEAR(error, c.errorsMm[m], 1e-6);  // mm, of fields of 30 mm: squares are known to 1e-14
      left += error * error;
      total += innerProduct(p, member, member);
    }
    EXPECT_LE(left, (1 - energy) * total * (1 + 1e-6));
  }
}

TEST(ModeCompression, RepeatedFieldsAddNoMode) {
  Problem p = problem(4, 30, 4);
  p.fields.push_back(2 * p.fields[0] - p.fields[3]);
  p.combinations.conservativeResize(30, 5);
  p.combinations.col(4).setConstant(1.5);
  const CompressedFields compressed = compressFields(p.fields, p.combinations, p.volumes, 1);
  EXPECT_EQ(compressed.modes.size(), 4u);
  EXPECT_LT(
      (fieldOf(compressed.modes, compressed.coefficients.row(9)) - memberOf(p, 9)).cwiseAbs().maxCoeff(),
      1e-9);  // mm
}

TEST(ModeCompression, NothingToHoldGivesNoMode) {
  const Problem p = problem(2, 3, 5);
  const CompressedFields zero = compressFields(p.fields, Eigen::MatrixXd::Zero(3, 2), p.volumes, 0.99);
  EXPECT_TRUE(zero.modes.empty());
  const CompressedFields none = compressFields({}, Eigen::MatrixXd::Zero(3, 0), p.volumes, 0.99);
  EXPECT_TRUE(none.modes.empty());
  EXPECT_EQ(none.errorsMm, VectorXd::Zero(3));
}

TEST(ModeCompression, GivesTheSameBitsForAnyNumberOfThreads) {
  const Problem p = problem(6, 20, 6);
  setThreads(1);
  const CompressedFields one = compressFields(p.fields, p.combinations, p.volumes, 0.9999);
  setThreads(3);
  const CompressedFields three = compressFields(p.fields, p.combinations, p.volumes, 0.9999);
  setThreads(0);
  EXPECT_EQ(one.coefficients, three.coefficients);
  for (std::size_t k = 0; k < one.modes.size(); ++k) EXPECT_EQ(one.modes[k], three.modes[k]);
}

}  // namespace
}  // namespace falciform::test
