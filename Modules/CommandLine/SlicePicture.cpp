#include "Modules/CommandLine/SlicePicture.h"

#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Geometry/PlaneSection.h"

namespace falciform::commandline {
namespace {

constexpr int kWidth = 560, kHeight = 440;
constexpr double kMarginMm = 20;
/// Hounsfield units: the usual window for a liver.
constexpr double kLevel = 80, kWindow = 400;
using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kNow{255, 214, 10}, kWas{90, 200, 250};

/// The part of an axial cut that a picture shows.
struct Frame {
  double z = 0, mmPerPixel = 1;
  Vector3d middle = Vector3d::Zero();

  [[nodiscard]] Vector3d place(double column, double row) const {
    return {middle.x() + (column - kWidth / 2.0) * mmPerPixel,
            middle.y() + (row - kHeight / 2.0) * mmPerPixel, z};
  }
  [[nodiscard]] Eigen::Vector2d pixel(const Vector3d& mm) const {
    return {(mm.x() - middle.x()) / mmPerPixel + kWidth / 2.0,
            (mm.y() - middle.y()) / mmPerPixel + kHeight / 2.0};
  }
};

/// Trilinear, NaN outside.
double valueAt(const Image& ct, const Matrix4d& indexFromWorld, const Vector3d& mm) {
  const Vector3d index = (indexFromWorld * mm.homogeneous()).head<3>();
  Vector3i low;
  for (int a = 0; a < 3; ++a) {
    if (!(index[a] >= -0.5 && index[a] <= ct.size[a] - 0.5)) return std::nan("");
    low[a] = std::clamp(static_cast<int>(std::floor(index[a])), 0, std::max(0, ct.size[a] - 2));
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    Vector3i at;
    for (int a = 0; a < 3; ++a) {
      const double share = std::clamp(index[a] - low[a], 0.0, 1.0);
      const bool upper = (corner >> a & 1) != 0;
      weight *= upper ? share : 1 - share;
      at[a] = std::min(low[a] + (upper ? 1 : 0), ct.size[a] - 1);
    }
    sum += weight * static_cast<double>(ct.at(at[0], at[1], at[2]));
  }
  return sum;
}

RenderedImage greySlice(const Image& ct, const Frame& frame) {
  RenderedImage image{.width = kWidth, .height = kHeight, .rgb = {}};
  image.rgb.assign(static_cast<std::size_t>(kWidth) * kHeight * 3, 0);
  const Matrix4d indexFromWorld = ct.worldFromIndex.inverse();
  std::size_t i = 0;
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column, i += 3) {
      const double value = valueAt(ct, indexFromWorld, frame.place(column + 0.5, row + 0.5));
      if (std::isnan(value)) continue;
      const double grey = std::clamp((value - kLevel) / kWindow + 0.5, 0.0, 1.0);
      std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(i), 3,
                  static_cast<std::uint8_t>(std::lround(255 * grey)));
    }
  return image;
}

/// Two pixels thick; dashes by place, so that they do not depend on how the outline is cut into segments.
void drawOutline(RenderedImage& image, const Frame& frame, const Surface& surface, const Colour& colour,
                 bool dashed) {
  const Points ends = planeSection(surface, 2, frame.z);
  for (Index s = 0; s + 1 < ends.rows(); s += 2) {
    const Eigen::Vector2d from = frame.pixel(ends.row(s).transpose()),
                          to = frame.pixel(ends.row(s + 1).transpose());
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * (to - from).norm())));
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector2d at = from + (to - from) * k / steps;
      if (dashed && (static_cast<int>(at.x() / 6) + static_cast<int>(at.y() / 6)) % 2 != 0) continue;
      for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
          const int x = static_cast<int>(at.x()) + dx, y = static_cast<int>(at.y()) + dy;
          if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) continue;
          const std::size_t pixel = 3 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
          std::copy(colour.begin(), colour.end(), image.rgb.begin() + static_cast<std::ptrdiff_t>(pixel));
        }
    }
  }
}

}  // namespace

SlicePictures slicePictures(const Image& before, const Image& after, const Surface& preop,
                            const TetrahedralMesh& mesh, const UpdateResult& update) {
  const Points bending(MeshPlaces(mesh, preop.points).interpolate(update.displacements));
  Surface bent = preop;
  bent.points += bending;
  Index most = 0;
  bending.leftCols<2>().rowwise().squaredNorm().maxCoeff(&most);

  Frame frame;
  frame.z = bent.points(most, 2);
  const Vector3d low =
                     preop.points.colwise().minCoeff().cwiseMin(bent.points.colwise().minCoeff()).transpose(),
                 high =
                     preop.points.colwise().maxCoeff().cwiseMax(bent.points.colwise().maxCoeff()).transpose();
  frame.middle = (low + high) / 2;
  frame.mmPerPixel =
      std::max((high.x() - low.x() + 2 * kMarginMm) / kWidth, (high.y() - low.y() + 2 * kMarginMm) / kHeight);
  SlicePictures pictures{greySlice(before, frame), greySlice(after, frame)};
  drawOutline(pictures.before, frame, preop, kWas, false);
  drawOutline(pictures.after, frame, preop, kWas, true);
  drawOutline(pictures.after, frame, bent, kNow, false);
  return pictures;
}

}  // namespace falciform::commandline
