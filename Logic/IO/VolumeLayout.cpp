#include "Logic/IO/VolumeLayout.h"

#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

constexpr std::int64_t kMostVoxels = std::int64_t{1} << 31;
constexpr double kFarthestMm = 1e6;

}  // namespace

std::size_t bytesOf(Scalar scalar) {
  switch (scalar) {
    case Scalar::Int8:
    case Scalar::UInt8:
      return 1;
    case Scalar::Int16:
    case Scalar::UInt16:
      return 2;
    case Scalar::Int32:
    case Scalar::UInt32:
    case Scalar::Float32:
      return 4;
    default:
      return 8;
  }
}

void refuseVolume(const std::filesystem::path& file, const std::string& message) {
  throw InputError("'" + file.string() + "': " + message);
}

Vector3i checkedSize(const std::filesystem::path& file, std::int64_t i, std::int64_t j, std::int64_t k) {
  const auto text = [&] { return std::to_string(i) + " x " + std::to_string(j) + " x " + std::to_string(k); };
  std::int64_t voxels = 1;
  for (const std::int64_t n : {i, j, k}) {
    if (n < 1)
      refuseVolume(file, "the header gives " + text() + " voxels; each must be 1 or more: export it again");
    if (n > kMostVoxels / voxels)
      refuseVolume(file,
                   "the header gives " + text() + " voxels, more than 2^31 in all; crop or resample it");
    voxels *= n;
  }
  return {static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)};
}

void checkGeometry(VolumeLayout& layout) {
  const Matrix4d& m = layout.worldFromIndex;
  if (!m.allFinite())
    refuseVolume(layout.file,
                 "its orientation, spacing or origin holds a value that is not a number; export it again");
  const Vector3d spacing = m.topLeftCorner<3, 3>().colwise().norm();
  if (spacing.minCoeff() < 1e-6)
    refuseVolume(layout.file, "its voxel spacing is " + shortText(spacing.minCoeff()) +
                                  " mm along one axis; it must be above 0: export it again");
  const Matrix3d axes = m.topLeftCorner<3, 3>() * spacing.cwiseInverse().asDiagonal();
  if (std::abs(axes.determinant()) < 1e-3)
    refuseVolume(layout.file, "its direction matrix is singular (determinant " +
                                  shortText(axes.determinant()) + "); export it with three different axes");
  const Vector3d lengths = spacing.cwiseProduct(layout.size.cast<double>());
  const double reach = m.topRightCorner<3, 1>().norm() + lengths.sum();
  if (!(reach <= kFarthestMm))
    refuseVolume(layout.file,
                 "it reaches " + shortText(reach) +
                     " mm from the origin; a body lies within 1e6 mm: correct its spacing or origin");
  if (!std::isfinite(layout.slope) || !std::isfinite(layout.intercept) || layout.slope == 0)
    refuseVolume(layout.file, "its intensity scale is " + shortText(layout.slope) + " and " +
                                  shortText(layout.intercept) +
                                  "; both must be finite and the first not 0: export it again");
  if (lengths.maxCoeff() < 2)
    layout.warnings.push_back("the volume is only " + shortText(lengths.maxCoeff()) +
                              " mm long: its header may be in metres; correct the spacing if so");
  if (lengths.maxCoeff() > 20000)
    layout.warnings.push_back("the volume is " + shortText(lengths.maxCoeff()) +
                              " mm long: its header may be in micrometres; correct the spacing if so");
  const Matrix3d skew = axes.transpose() * axes - Matrix3d::Identity();
  if (skew.cwiseAbs().maxCoeff() > 1e-3)
    layout.warnings.push_back(
        "the volume's axes are not perpendicular (tilted gantry); slices of it cannot be shown");
}

Matrix4d lpsFromRas() { return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal(); }

}  // namespace falciform
