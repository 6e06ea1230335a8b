#include "Logic/Acquisition/ImplicitBodies.h"

#include <algorithm>
#include <cmath>

namespace falciform {

double roundIntersection(double a, double b, double radius) {
  const double u = std::max(a + radius, 0.0), v = std::max(b + radius, 0.0);
  return std::min(-radius, std::max(a, b)) + std::sqrt(u * u + v * v);
}

double smoothUnion(double a, double b, double blend) {
  const double h = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - h * h * h * blend / 6.0;
}

double smoothDifference(double a, double b, double blend) { return -smoothUnion(-a, b, blend); }

double smoothStep(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double bell(double value, double width) {
  const double t = value / width;
  return std::exp(-0.5 * t * t);
}

double DomedBody::distance(const Vector3d& p) const {
  const Vector3d d = p - centre;
  const double above = d.z() - rise * d.x(), behind = d.y() - sweep * d.x();
  const Vector3d r(radii.x(), radii.y(), above >= 0 ? radii.z() : radiusBelow);
  const Vector3d q = Vector3d(d.x(), behind, above).cwiseQuotient(r);
  const Vector3d size = q.cwiseAbs();
  const Vector3d power = size.array().pow(exponent - 1);
  const double sum = power.dot(size);
  if (sum < 1e-12) return -radii.minCoeff();
  const double gauge = std::pow(sum, 1 / exponent);
  // The gauge is homogeneous of degree 1, so gauge - 1 over its gradient is a distance to first order.
  Vector3d slope = power.cwiseQuotient(r) / (sum / gauge);
  for (int k = 0; k < 3; ++k)
    if (q[k] < 0) slope[k] = -slope[k];
  slope.x() -= rise * slope.z() + sweep * slope.y();
  return (gauge - 1.0) / slope.norm();
}

Eigen::Matrix<double, 2, 3> DomedBody::box() const {
  const double shiftY = std::abs(sweep) * radii.x(), shiftZ = std::abs(rise) * radii.x();
  Eigen::Matrix<double, 2, 3> box;
  box.row(0) = (centre - Vector3d(radii.x(), radii.y() + shiftY, radiusBelow + shiftZ)).transpose();
  box.row(1) = (centre + Vector3d(radii.x(), radii.y() + shiftY, radii.z() + shiftZ)).transpose();
  return box;
}

double Ellipsoid::distance(const Vector3d& p) const {
  const Vector3d q = (p - centre).cwiseQuotient(radii);
  const double gauge = q.norm();
  if (gauge < 1e-9) return -radii.minCoeff();
  return gauge * (gauge - 1.0) / q.cwiseQuotient(radii).norm();
}

double TaperedCapsule::distance(const Vector3d& p) const {
  const Vector3d axis = b - a;
  const double t = std::clamp((p - a).dot(axis) / std::max(axis.squaredNorm(), 1e-12), 0.0, 1.0);
  return (p - a - t * axis).norm() - (radiusA + t * (radiusB - radiusA));
}

}  // namespace falciform
