#include "Logic/Registration/ElasticEquations.h"

#include <gtest/gtest.h>

#include "Logic/Core/Draws.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TEST(ElasticEquations, AreTheSumsOverAllEntries) {
  const ElasticModes modes(test::lumpyBody(3));
  constexpr int kM = ElasticModes::kMonomials;
  using Row = Eigen::Matrix<double, ElasticModes::kUnknowns, 1>;
  ElasticModes::Energy matrix = ElasticModes::Energy::Zero();
  Row right = Row::Zero();
  ElasticEquations first, equations;
  ElasticEquations::Observations some(10), others(10);
  Draws draws(7);
  const auto see = [&](const Vector3d& x, const Vector3d& n, double value, double weight) {
    Row row;
    for (int k = 0; k < 3; ++k) row.segment<kM>(k * kM) = n[k] * modes.monomials(x);
    matrix += weight * row * row.transpose();
    right += weight * value * row;
  };
  for (int i = 0; i < 10; ++i) {
    const Vector3d x = 40 * draws.normal3(), n = draws.normal3().normalized(), value = draws.normal3();
    const double weight = 0.1 + draws.uniform();
    some.addAlong(x, n, value.x(), weight);
    see(x, n, value.x(), weight);
    others.addWhole(-x, value, weight);
    for (int k = 0; k < 3; ++k) see(-x, Vector3d::Unit(k), value[k], weight);
  }
  first.add(modes, some);
  equations.add(modes, others);
  equations.add(first);
  // Rounding of some twenty terms.
  EXPECT_LT((equations.matrix() - matrix).norm(), 1e-13 * matrix.norm());
  EXPECT_LT((equations.right() - right).norm(), 1e-13 * right.norm());
}

}  // namespace
}  // namespace falciform
