#include "Logic/Registration/ClosestPointTransform.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/ClosestPointLoop.h"

namespace falciform {

namespace {

constexpr double kVoxelMm = 3, kMarginMm = 30;
constexpr double kMostNodes = 2e6;
constexpr double kApart = 3.5;  // voxels: two diagonals; on a smooth side closest points lie nearer

}  // namespace

ClosestPointTransform::ClosestPointTransform(const LabelledTarget& target, double voxelMm, double marginMm)
    : voxel_(voxelMm) {
  const Eigen::Matrix<double, 2, 3> box = boundingBox(target.points());
  const Vector3d size = (box.row(1) - box.row(0)).transpose() + Vector3d::Constant(2 * marginMm);
  while ((size / voxel_ + Vector3d::Constant(2)).prod() > kMostNodes) voxel_ *= 1.1;
  origin_ = box.row(0).transpose() - Vector3d::Constant(marginMm);
  count_ = (size / voxel_).array().ceil().cast<int>() + 1;
  closest_.resize(static_cast<Index>(count_.x()) * count_.y() * count_.z(), 3);
  const auto rows = static_cast<std::size_t>(count_.y()) * static_cast<std::size_t>(count_.z());
  forEachChunk(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      int guess = -1;  // the neighbour's closest point: sooner, never another answer
      for (int x = 0; x < count_.x(); ++x) {
        const Vector3i at(x, row % count_.y(), row / count_.y());
        guess = target.closest(origin_ + voxel_ * at.cast<double>(), patch::kNone, 1, guess).index;
        closest_.row(node(at)) = target.points().row(guess);
      }
    }
  });
}

Vector3d ClosestPointTransform::closest(const Vector3d& query) const {
  const Vector3d last = (count_ - Vector3i::Ones()).cast<double>();
  const Vector3d place = ((query - origin_) / voxel_).cwiseMax(0).cwiseMin(last);
  const Vector3i low = place.cast<int>().cwiseMin(count_ - Vector3i::Constant(2));
  const Vector3d share = place - low.cast<double>();
  std::array<Vector3d, 8> corners;
  Vector3d mean = Vector3d::Zero(), least = Vector3d::Constant(INFINITY), most = -least;
  for (int c = 0; c < 8; ++c) {
    const Vector3i step(c & 1, c >> 1 & 1, c >> 2 & 1);
    Vector3d& corner = corners[static_cast<std::size_t>(c)];
    corner = closest_.row(node(low + step)).transpose();
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= step[a] ? share[a] : 1 - share[a];
    mean += weight * corner;
    least = least.cwiseMin(corner);
    most = most.cwiseMax(corner);
  }
  if ((most - least).norm() <= kApart * voxel_) return mean;
  return *std::min_element(corners.begin(), corners.end(), [&](const Vector3d& a, const Vector3d& b) {
    return (a - query).squaredNorm() < (b - query).squaredNorm();
  });
}

PatchIcpResult registerClosestPointTransform(const PreparedPreop& preop, const Surface& scan,
                                             const RegistrationSettings& settings, const Isometry3d& start,
                                             const Progress& progress, const IterationObserver& observer) {
  const ClosestPointTransform map(preop.target(), kVoxelMm, kMarginMm);
  const MatchPoints match = [&](const Points& moved, Points& matched) {
    matched.resize(moved.rows(), 3);
    forEachChunk(static_cast<std::size_t>(moved.rows()), 512, [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
        matched.row(i) = map.closest(moved.row(i).transpose()).transpose();
    });
  };
  return runClosestPointLoop(scan.points, match, settings, start, progress, observer);
}

}  // namespace falciform
