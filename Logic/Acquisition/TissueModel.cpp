#include "Logic/Acquisition/TissueModel.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace falciform {

namespace {

/// Lightness differs by the slope of the surface to the lamp, hue hardly: units of Lab.
const Vector3d kLeastSpread(9, 4.5, 4.5);

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

TissueModel::TissueModel(const Points& lab, const std::vector<int>& ids) {
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const int i : ids) values.push_back(lab(i, k));
    mean_[k] = median(std::move(values));
  }
  // The middle half, by the distance in units of the least spread.
  std::vector<std::pair<double, int>> order;
  for (const int i : ids)
    order.emplace_back((lab.row(i).transpose() - mean_).cwiseQuotient(kLeastSpread).squaredNorm(), i);
  std::sort(order.begin(), order.end());
  order.resize((order.size() + 1) / 2);
  Matrix3d covariance = Matrix3d::Zero();
  for (const auto& [unused, i] : order) {
    const Vector3d d = lab.row(i).transpose() - mean_;
    covariance += d * d.transpose() / static_cast<double>(order.size());
  }
  const Matrix3d least = kLeastSpread.cwiseAbs2().asDiagonal();
  precision_ = (covariance + least).inverse();
}

double TissueModel::distance(const Vector3d& lab) const {
  const Vector3d d = lab - mean_;
  return std::sqrt(std::max(d.dot(precision_ * d), 0.0));
}

bool looksLikeLiver(const Vector3d& lab) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double chroma = std::hypot(lab[1], lab[2]), hueDeg = std::atan2(lab[2], lab[1]) * kDegrees;
  // Fat is yellower (70 and up) and lighter, gauze greyer, skin lighter, drapes green and blue.
  return lab[0] > 8 && lab[0] < 58 && chroma > 12 && hueDeg > 0 && hueDeg < 62;
}

}  // namespace falciform
