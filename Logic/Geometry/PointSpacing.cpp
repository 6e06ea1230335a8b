#include "Logic/Geometry/PointSpacing.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "Logic/Core/Median.h"
#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr Index kSamples = 2000;
constexpr int kAround = 12, kFitted = 60;

/// Median over mean of chi squared / n with n = 54 degrees of freedom (Wilson, Hilferty 1931).
const double kMedianOfMean = std::pow(1 - 2.0 / (9 * 54), 3);

/// f(index of a point) for evenly chosen points.
template <class F>
std::vector<double> atSamples(const Points& points, const F& f) {
  const Index count = std::min(points.rows(), kSamples);
  std::vector<double> values(static_cast<std::size_t>(count));
  forEachChunk(values.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) values[k] = f(static_cast<Index>(k) * points.rows() / count);
  });
  return values;
}

/// Mean square, mm^2, of what the quadric over the plane of the points around leaves over.
double leftOver(const Points& points, const KdTree& tree, Index i) {
  const std::vector<Neighbour> around = tree.nearest(points.row(i), kFitted);
  const Index n = std::ssize(around);
  Points near(n, 3);
  for (Index k = 0; k < n; ++k) near.row(k) = points.row(around[static_cast<std::size_t>(k)].index);
  const Vector3d middle = near.colwise().mean();
  near.rowwise() -= middle.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(Matrix3d(near.transpose() * near));
  const Points turned = near * axes.eigenvectors();  // heights first, then the plane
  const double size = std::sqrt(turned.rowwise().squaredNorm().maxCoeff());
  if (!(size > 0) || n < 12) return 0;
  Eigen::MatrixXd terms(n, 6);
  for (Index k = 0; k < n; ++k) {
    const double u = turned(k, 1) / size, v = turned(k, 2) / size;
    terms.row(k) << 1, u, v, u * u, u * v, v * v;
  }
  const VectorXd heights = turned.col(0);
  const VectorXd fit = terms.colPivHouseholderQr().solve(heights);
  return (heights - terms * fit).squaredNorm() / static_cast<double>(n - 6);
}

}  // namespace

double pointSpacing(const Points& points, const KdTree& tree) {
  std::vector<double> spacings = atSamples(points, [&](Index i) {
    const std::vector<Neighbour> around = tree.nearest(points.row(i), kAround + 1);
    return std::sqrt(std::numbers::pi * around.back().squaredDistance /
                     (static_cast<double>(around.size()) - 0.5));
  });
  return medianInPlace(spacings);
}

double pointNoise(const Points& points, const KdTree& tree) {
  std::vector<double> squares = atSamples(points, [&](Index i) { return leftOver(points, tree, i); });
  return std::sqrt(medianInPlace(squares) / kMedianOfMean);
}

}  // namespace falciform
