#include "Logic/Geometry/RbfFunction.h"

#include <algorithm>
#include <cmath>

namespace falciform {

Jet RbfFunction::Quadric::jet(const Vector3d& place) const {
  const Vector3d x = (place - centre) / scaleMm;
  Jet jet;
  jet.value = a[0] + a.segment<3>(1).dot(x) + a.segment<3>(4).dot(x.cwiseProduct(x)) + a[7] * x.x() * x.y() +
              a[8] * x.y() * x.z() + a[9] * x.z() * x.x();
  jet.hessian << 2 * a[4], a[7], a[9], a[7], 2 * a[5], a[8], a[9], a[8], 2 * a[6];
  jet.gradient = (a.segment<3>(1) + jet.hessian * x) / scaleMm;
  jet.hessian /= scaleMm * scaleMm;
  return jet;
}

double RbfFunction::value(const Vector3d& place) const {
  double value = quadric_.jet(place).value;
  for (const RbfLattice& level : *levels_) level.addValue(place, value);
  return value;
}

Jet RbfFunction::jet(const Vector3d& place) const {
  Jet jet = quadric_.jet(place);
  for (const RbfLattice& level : *levels_) level.addJet(place, jet);
  return jet;
}

Vector3d RbfFunction::ontoZero(const Vector3d& place, double reachMm) const {
  constexpr int kSteps = 5;           // the function is nearly a distance: each step squares the error
  constexpr double kNear = 1e-6;      // mm
  constexpr double kFlattest = 0.25;  // of the slope, which is 1 for a distance
  Vector3d p = place;
  for (int n = 0; n < kSteps; ++n) {
    const Jet here = jet(p);
    if (std::abs(here.value) < kNear) break;
    Vector3d move =
        -here.value / std::max(here.gradient.squaredNorm(), kFlattest * kFlattest) * here.gradient;
    if (const double length = move.norm(); length > reachMm) move *= reachMm / length;
    p += move;
  }
  return p;
}

Vector3d normalOf(const Jet& jet) { return jet.gradient.stableNormalized(); }

double meanCurvatureOf(const Jet& jet) {
  const double slope = jet.gradient.norm();
  return (jet.hessian.trace() * slope * slope - jet.gradient.dot(jet.hessian * jet.gradient)) /
         (2 * slope * slope * slope);
}

}  // namespace falciform
