#include "Logic/Deformation/SegmentLabels.h"

#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

/// Voxels around a point, nearest found by looking at all within reach.
class NearestLabel {
 public:
  NearestLabel(const LabelMap& labels, double reachMm) : labels_(labels), reach_(reachMm) {
    const Matrix3d axes = labels.worldFromIndex.topLeftCorner<3, 3>();
    if (!(std::abs(axes.determinant()) > 0) || labels.voxels.empty())
      throw InputError("the segment map has no voxels or a broken orientation; export it again");
    indexFromWorld_ = labels.worldFromIndex.inverse();
    // A sphere's extent along an index is its radius times the length of that row of the inverse.
    steps_ = reachMm * indexFromWorld_.topLeftCorner<3, 3>().rowwise().norm();
    const Matrix3d gram = axes.transpose() * axes;
    orthogonal_ = (gram - Matrix3d(gram.diagonal().asDiagonal())).cwiseAbs().maxCoeff() <
                  1e-6 * gram.diagonal().minCoeff();
  }

  [[nodiscard]] int at(const Vector3d& point) const {
    const Vector3d index = (indexFromWorld_ * point.homogeneous()).head<3>();
    const Vector3i own = index.array().round().cwiseMax(-1e9).cwiseMin(1e9).cast<int>();
    if (orthogonal_ && inside(own) && (labels_.world(own.cast<double>()) - point).norm() <= reach_)
      if (const int label = labels_.at(own.x(), own.y(), own.z()); label > 0) return label;
    Vector3i low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const double last = labels_.size[axis] - 1;
      low[axis] = static_cast<int>(std::clamp(std::ceil(index[axis] - steps_[axis]), 0.0, last + 1));
      high[axis] = static_cast<int>(std::clamp(std::floor(index[axis] + steps_[axis]), -1.0, last));
    }
    double best = reach_ * reach_ * (1 + 1e-12);
    int label = 0;
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) {
          const int here = labels_.at(i, j, k);
          if (here == 0) continue;
          const double squared = (labels_.world(Vector3d(i, j, k)) - point).squaredNorm();
          if (squared < best) best = squared, label = here;
        }
    return label;
  }

 private:
  [[nodiscard]] bool inside(const Vector3i& index) const {
    return index.minCoeff() >= 0 && (index.array() < labels_.size.array()).all();
  }

  const LabelMap& labels_;
  double reach_;
  Matrix4d indexFromWorld_;
  Vector3d steps_;
  bool orthogonal_ = false;
};

}  // namespace

VectorXd labelsAtPoints(const Points& pointsLps, const LabelMap& labels, double reachMm) {
  const NearestLabel nearest(labels, reachMm);
  VectorXd found(pointsLps.rows());
  forEachChunk(static_cast<std::size_t>(pointsLps.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      found[row] = nearest.at(pointsLps.row(row).transpose());
    }
  });
  return found;
}

}  // namespace falciform
