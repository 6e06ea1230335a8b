#include "Logic/Geometry/RbfLattice.h"

#include <cmath>

#include "Logic/Geometry/RbfKernel.h"

namespace falciform {

namespace {

/// Nodes beyond the box on each side: what reaches into it, and what those overlap with.
constexpr int kMargin = 2 * RbfLattice::kReach + 1;

}  // namespace

RbfLattice::RbfLattice(const Vector3d& low, const Vector3d& high, double stepMm, const RbfKernel& kernel)
    : kernel_(kernel), step_(stepMm) {
  counts_ = ((high - low) / stepMm).array().ceil().cast<int>() + 1 + 2 * kMargin;
  origin_ = low.array() - kMargin * stepMm;
  coefficient_.assign(static_cast<std::size_t>(counts_.x()) * static_cast<std::size_t>(counts_.y()) *
                          static_cast<std::size_t>(counts_.z()),
                      0.0);
}

void RbfLattice::use(const std::vector<char>& flags) {
  centres_.clear();
  constexpr int rim = 2 * kReach;
  for (int z = rim; z + rim < counts_.z(); ++z)
    for (int y = rim; y + rim < counts_.y(); ++y)
      for (int x = rim; x + rim < counts_.x(); ++x)
        if (flags[static_cast<std::size_t>(node(x, y, z))] != 0) centres_.push_back(node(x, y, z));
}

void RbfLattice::setCoefficients(const VectorXd& coefficients) {
  for (std::size_t k = 0; k < centres_.size(); ++k)
    coefficient_[static_cast<std::size_t>(centres_[k])] = coefficients[static_cast<Index>(k)];
}

/// Calls visit(offset in steps, squared length, coefficient) for the nodes in reach that are in use.
template <class Visit>
void RbfLattice::visit(const Vector3d& place, Visit&& visit) const {
  const Vector3d at = coordinates(place);
  if (!holds(at)) return;
  const Vector3i cell = at.array().floor().cast<int>();
  const Vector3d t = at - cell.cast<double>();
  constexpr double reach2 = kReach * kReach;
  for (int dz = 1 - kReach; dz <= kReach; ++dz) {
    const double z = t.z() - dz, z2 = z * z;
    for (int dy = 1 - kReach; dy <= kReach; ++dy) {
      const double y = t.y() - dy, yz2 = y * y + z2;
      if (yz2 >= reach2) continue;
      const double* row =
          &coefficient_[static_cast<std::size_t>(node(cell.x(), cell.y() + dy, cell.z() + dz))];
      for (int dx = 1 - kReach; dx <= kReach; ++dx) {
        const double x = t.x() - dx, r2 = x * x + yz2;
        if (r2 < reach2 && row[dx] != 0) visit(Vector3d(x, y, z), r2, row[dx]);
      }
    }
  }
}

void RbfLattice::addValue(const Vector3d& place, double& value) const {
  visit(place, [&](const Vector3d&, double r2, double c) { value += c * kernel_.value(std::sqrt(r2)); });
}

void RbfLattice::addSlope(const Vector3d& place, double& value, Vector3d& gradient) const {
  Vector3d sum = Vector3d::Zero();
  visit(place, [&](const Vector3d& x, double r2, double c) {
    const double r = std::sqrt(r2);
    value += c * kernel_.value(r);
    sum += 2 * c * kernel_.first(r) * x;
  });
  gradient += sum / step_;
}

void RbfLattice::addJet(const Vector3d& place, Jet& jet) const {
  Vector3d gradient = Vector3d::Zero();
  Matrix3d outer = Matrix3d::Zero();
  double value = 0, diagonal = 0;
  visit(place, [&](const Vector3d& x, double r2, double c) {
    const double r = std::sqrt(r2);
    value += c * kernel_.value(r);
    const double first = 2 * c * kernel_.first(r);
    gradient += first * x;
    diagonal += first;
    outer += (4 * c * kernel_.second(r)) * x * x.transpose();
  });
  const double perMm = 1 / step_;
  jet.value += value;
  jet.gradient += perMm * gradient;
  jet.hessian += perMm / step_ * outer;
  jet.hessian.diagonal().array() += perMm / step_ * diagonal;
}

}  // namespace falciform
