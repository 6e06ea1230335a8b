#include "Testing/Logic/Deformation/Cohort/RandomCohort.h"

#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"
#include "Logic/Deformation/Cohort/MapCorrelation.h"

namespace falciform::test {

Cohort randomCohort(double groupShare, std::uint64_t seed, double commonPattern) {
  Cohort cohort;
  cohort.groups = {"A", "B", "C"};
  cohort.groupOf = {-1, -1, 1, 0, 0, 1, 2, 0, 2, 2};
  constexpr Index vertices = 300, waves = 12;
  Eigen::MatrixXd basis(vertices, waves);
  for (Index i = 0; i < vertices; ++i)
    for (Index w = 0; w < waves; ++w)
      basis(i, w) = std::cos(std::numbers::pi * static_cast<double>((w + 1) * i) / vertices);
  Draws draws(seed);
  const auto heights = [&] {
    VectorXd h(waves);
    for (double& value : h) value = draws.normal();
    return h;
  };
  std::vector<VectorXd> ofGroup{heights(), heights(), heights()};
  Eigen::MatrixXd maps(vertices, 10);
  for (std::size_t c = 0; c < 10; ++c) {
    cohort.cases.push_back(std::to_string(c));
    const VectorXd own = heights(), shared = cohort.groupOf[c] < 0
                                                 ? heights()
                                                 : ofGroup[static_cast<std::size_t>(cohort.groupOf[c])];
    maps.col(static_cast<Index>(c)) =
        basis * (std::sqrt(groupShare) * shared + std::sqrt(1 - groupShare) * own);
  }
  const VectorXd common = commonPattern * (basis * heights());
  for (Index c = 0; c < maps.cols(); ++c) maps.col(c) += draws.normal() * common;
  cohort.correlation = mapCorrelation(maps, commonCoverage(maps), cohort.cases);
  return cohort;
}

}  // namespace falciform::test
