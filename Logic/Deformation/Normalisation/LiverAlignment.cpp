#include "Logic/Deformation/Normalisation/LiverAlignment.h"

#include <Eigen/Dense>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"
#include "Logic/Deformation/Normalisation/FieldSample.h"

namespace falciform {

namespace {

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

struct Normal {
  Matrix12d matrix = Matrix12d::Zero();
  Vector12d right = Vector12d::Zero();
  double squares = 0;
};

constexpr int kIterations = 40;
constexpr double kSettledMm = 0.01;
constexpr std::size_t kChunk = 2048;
constexpr double kArmMm = 100;  // turns and stretches are measured by what they do this far out

class Alignment {
 public:
  Alignment(const GridField& source, const FieldSamples& target, double bandMm)
      : source_(source), target_(target), band_(bandMm), centre_(target.places.colwise().mean()) {}

  /// Unknowns 0-2 shift, 3-11 linear part about the centre; `turnsOnly` keeps it rigid.
  [[nodiscard]] Eigen::Affine3d fit(Eigen::Affine3d map, bool turnsOnly, const Progress& progress) const {
    Normal now = normalAt(map);
    double damping = 1e-3;
    for (int i = 0; i < kIterations; ++i) {
      progress.report(static_cast<double>(i) / kIterations);
      const auto [linear, shift] = step(now, turnsOnly, damping);
      const Eigen::Affine3d moved = stepped(map, linear, shift, turnsOnly);
      const Normal next = normalAt(moved);
      if (next.squares < now.squares) {
        const double motion = shift.norm() + linear.norm() * kArmMm;
        map = moved;
        now = next;
        damping = std::max(damping / 4, 1e-6);
        if (motion < kSettledMm) break;
      } else {
        damping *= 8;
        if (damping > 1e6) break;
      }
    }
    return map;
  }

 private:
  [[nodiscard]] Normal normalAt(const Eigen::Affine3d& map) const {
    const std::size_t count = target_.values.size();
    std::vector<Normal> parts(count / kChunk + 1);
    forEachChunk(count, kChunk, [&](std::size_t begin, std::size_t end) {
      Normal& part = parts[begin / kChunk];
      for (std::size_t i = begin; i < end; ++i) {
        const Vector3d from = target_.places.row(static_cast<Index>(i)).transpose();
        const FieldSample sample = sampleField(source_, map * from);
        const double wanted = std::clamp<double>(target_.values[i], -band_, band_);
        const double off = std::clamp(sample.value, -band_, band_) - wanted;
        part.squares += off * off;
        if (std::abs(sample.value) >= band_) continue;
        const Vector3d arm = map.linear() * (from - centre_) / kArmMm;
        Vector12d row;
        row << sample.slope, sample.slope.x() * arm, sample.slope.y() * arm, sample.slope.z() * arm;
        part.matrix.selfadjointView<Eigen::Lower>().rankUpdate(row);
        part.right -= off * row;
      }
    });
    Normal sum;
    for (const Normal& part : parts) {
      sum.matrix += part.matrix;
      sum.right += part.right;
      sum.squares += part.squares;
    }
    sum.matrix.triangularView<Eigen::StrictlyUpper>() = sum.matrix.transpose();
    return sum;
  }

  [[nodiscard]] std::pair<Matrix3d, Vector3d> step(const Normal& normal, bool turnsOnly,
                                                   double damping) const {
    Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(12, 12);
    if (turnsOnly) {
      basis = Eigen::MatrixXd::Zero(12, 6);
      basis.topLeftCorner<3, 3>().setIdentity();
      for (int axis = 0; axis < 3; ++axis) {
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;  // d(linear)(b, a) = 1, d(linear)(a, b) = -1
        basis(3 + 3 * b + a, 3 + axis) = 1;
        basis(3 + 3 * a + b, 3 + axis) = -1;
      }
    }
    Eigen::MatrixXd matrix = basis.transpose() * normal.matrix * basis;
    matrix.diagonal() *= 1 + damping;
    matrix.diagonal().array() += 1e-9;
    const Vector12d x = basis * matrix.ldlt().solve(basis.transpose() * normal.right);
    Matrix3d linear;
    linear << x.segment<3>(3).transpose(), x.segment<3>(6).transpose(), x.segment<3>(9).transpose();
    return {linear / kArmMm, x.head<3>()};
  }

  [[nodiscard]] Eigen::Affine3d stepped(const Eigen::Affine3d& map, const Matrix3d& linear,
                                        const Vector3d& shift, bool turnsOnly) const {
    const Vector3d turn(linear(2, 1), linear(0, 2), linear(1, 0));
    const Matrix3d by = turnsOnly ? rotationOf(turn) : Matrix3d(Matrix3d::Identity() + linear);
    Eigen::Affine3d moved;
    moved.linear() = by * map.linear();
    moved.translation() = map * centre_ + shift - moved.linear() * centre_;
    return moved;
  }

  const GridField& source_;
  const FieldSamples& target_;
  double band_;
  Vector3d centre_;
};

}  // namespace

Eigen::Affine3d alignLivers(const GridField& source, const FieldSamples& target, double bandMm,
                            const Eigen::Affine3d& start, const Progress& progress) {
  const Alignment alignment(source, target, bandMm);
  return alignment.fit(alignment.fit(start, true, progress.part(0, 0.5)), false, progress.part(0.5, 1));
}

}  // namespace falciform
