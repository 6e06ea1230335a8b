#include "Logic/Registration/ElasticEquations.h"

namespace falciform {

void ElasticEquations::Observations::addAlong(const Vector3d& x, const Vector3d& normal, double value,
                                              double weight) {
  const Vector3d weighted = weight * normal;
  places_.row(count_) = x.transpose();
  squares_.row(count_) << weighted.x() * normal.x(), weighted.x() * normal.y(), weighted.x() * normal.z(),
      weighted.y() * normal.y(), weighted.y() * normal.z(), weighted.z() * normal.z();
  pulls_.row(count_) = value * weighted.transpose();
  ++count_;
}

void ElasticEquations::Observations::addWhole(const Vector3d& x, const Vector3d& value, double weight) {
  places_.row(count_) = x.transpose();
  squares_.row(count_) << weight, 0, 0, weight, 0, weight;
  pulls_.row(count_) = weight * value.transpose();
  ++count_;
}

void ElasticEquations::add(const ElasticModes& modes, const Observations& seen) {
  if (seen.count_ == 0) return;
  const ElasticModes::Products products = modes.products(seen.places_.topRows(seen.count_));
  squares_.noalias() += products.transpose() * seen.squares_.topRows(seen.count_);
  pulls_.noalias() +=
      products.leftCols<ElasticModes::kMonomials>().transpose() * seen.pulls_.topRows(seen.count_);
}

void ElasticEquations::add(const ElasticEquations& others) {
  squares_ += others.squares_;
  pulls_ += others.pulls_;
}

ElasticModes::Energy ElasticEquations::matrix() const {
  constexpr int kM = ElasticModes::kMonomials;
  constexpr int kSquare[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  const ElasticModes::ProductTable& table = ElasticModes::productTable();
  ElasticModes::Energy matrix;
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 3; ++k) {
      const auto sums = squares_.col(kSquare[k][l]);
      for (int b = 0; b < kM; ++b)
        for (int a = 0; a < kM; ++a) matrix(k * kM + a, l * kM + b) = sums[table(a, b)];
    }
  return matrix;
}

ElasticEquations::Unknowns ElasticEquations::right() const {
  return Eigen::Map<const Unknowns>(pulls_.data());
}

}  // namespace falciform
