#include "Widgets/Views/SliceImage.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace falciform {
namespace {

/// Continuous index of the volume at the middle of pixel (column, row): a corner and two steps.
struct PixelIndices {
  Vector3d corner, perColumn, perRow;

  template <class T>
  PixelIndices(const Volume<T>& volume, SlicePlane plane, double at, const QRectF& mm, const QSize& pixels) {
    const SliceAxes axes = axesOf(plane);
    const Matrix4d indexFromWorld = volume.worldFromIndex.inverse();
    const auto index = [&](double column, double row) -> Vector3d {
      const QPointF place(mm.left() + column * mm.width() / pixels.width(),
                          mm.top() + row * mm.height() / pixels.height());
      return (indexFromWorld * axes.inPatient(place, at).homogeneous()).template head<3>();
    };
    corner = index(0.5, 0.5);
    perColumn = index(1.5, 0.5) - corner;
    perRow = index(0.5, 1.5) - corner;
  }
  [[nodiscard]] Vector3d at(int column, int row) const { return corner + column * perColumn + row * perRow; }
};

bool inside(const Vector3d& index, const Vector3i& size) {
  return index.x() >= -0.5 && index.y() >= -0.5 && index.z() >= -0.5 && index.x() <= size.x() - 0.5 &&
         index.y() <= size.y() - 0.5 && index.z() <= size.z() - 0.5;
}

double interpolated(const Image& ct, const Vector3d& index) {
  std::size_t low[3], high[3];
  double up[3];
  const std::size_t stride[3]{1, static_cast<std::size_t>(ct.size.x()),
                              static_cast<std::size_t>(ct.size.x()) * static_cast<std::size_t>(ct.size.y())};
  for (int a = 0; a < 3; ++a) {
    const double inner = std::clamp(index[a], 0.0, ct.size[a] - 1.0);
    const int voxel = static_cast<int>(inner);
    up[a] = inner - voxel;
    low[a] = static_cast<std::size_t>(voxel) * stride[a];
    high[a] = static_cast<std::size_t>(std::min(voxel + 1, ct.size[a] - 1)) * stride[a];
  }
  const auto along = [&](std::size_t rest) {
    return (1 - up[0]) * static_cast<double>(ct.voxels[low[0] + rest]) +
           up[0] * static_cast<double>(ct.voxels[high[0] + rest]);
  };
  const auto across = [&](std::size_t rest) {
    return (1 - up[1]) * along(low[1] + rest) + up[1] * along(high[1] + rest);
  };
  return (1 - up[2]) * across(low[2]) + up[2] * across(high[2]);
}

/// The nearest voxel's label at each pixel, row by row; 0 outside.
std::vector<int> nearestLabels(const LabelMap& labels, SlicePlane plane, double at, const QRectF& mm,
                               const QSize& pixels) {
  std::vector<int> found(static_cast<std::size_t>(pixels.width()) * static_cast<std::size_t>(pixels.height()),
                         0);
  if (labels.voxels.empty()) return found;
  const PixelIndices indices(labels, plane, at, mm, pixels);
  std::size_t pixel = 0;
  for (int row = 0; row < pixels.height(); ++row)
    for (int column = 0; column < pixels.width(); ++column, ++pixel) {
      const Vector3d index = indices.at(column, row);
      if (!inside(index, labels.size)) continue;
      const auto voxel = [&](int axis) {
        return std::clamp(static_cast<int>(std::floor(index[axis] + 0.5)), 0, labels.size[axis] - 1);
      };
      found[pixel] = labels.at(voxel(0), voxel(1), voxel(2));
    }
  return found;
}

QImage clearImage(const QSize& pixels) {
  QImage image(pixels, QImage::Format_ARGB32);
  image.fill(Qt::transparent);
  return image;
}

}  // namespace

SliceAxes axesOf(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::Axial:
      return {};
    case SlicePlane::Coronal:
      return {1, 0, 2, 1, -1, "R", "L", "H", "F"};
    case SlicePlane::Sagittal:
      return {0, 1, 2, 1, -1, "A", "P", "H", "F"};
  }
  return {};
}

QImage sliceOf(const Image& ct, SlicePlane plane, double at, const QRectF& mm, const QSize& pixels,
               const GreyWindow& window) {
  QImage image = clearImage(pixels);
  if (ct.voxels.empty()) return image;
  const double black = window.level - window.width / 2;
  const PixelIndices indices(ct, plane, at, mm, pixels);
  for (int row = 0; row < pixels.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < pixels.width(); ++column) {
      const Vector3d index = indices.at(column, row);
      if (!inside(index, ct.size)) continue;
      const double share = (interpolated(ct, index) - black) / window.width;
      const int grey = static_cast<int>(std::lround(255 * (share > 0 ? std::min(share, 1.0) : 0)));
      line[column] = qRgb(grey, grey, grey);
    }
  }
  return image;
}

QImage labelsOf(const LabelMap& labels, SlicePlane plane, double at, const QRectF& mm, const QSize& pixels,
                const std::function<QColor(int)>& colour, double filled) {
  QImage image = clearImage(pixels);
  const std::vector<int> found = nearestLabels(labels, plane, at, mm, pixels);
  const int width = pixels.width();
  int last = 0;
  QRgb rim = 0, inner = 0;
  for (int row = 0; row < pixels.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < width; ++column) {
      const int* here = &found[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column)];
      if (*here == 0) continue;
      if (*here != last) {
        const QColor own = colour(last = *here);
        rim = own.rgb();
        inner = qRgba(own.red(), own.green(), own.blue(), static_cast<int>(std::lround(255 * filled)));
      }
      const bool border = (column > 0 && here[-1] != *here) || (column + 1 < width && here[1] != *here) ||
                          (row > 0 && here[-width] != *here) ||
                          (row + 1 < pixels.height() && here[width] != *here);
      line[column] = border ? rim : inner;
    }
  }
  return image;
}

QImage hatchOf(const LabelMap& flags, SlicePlane plane, double at, const QRectF& mm, const QSize& pixels,
               const QColor& colour) {
  constexpr int kEvery = 6, kWide = 2;
  QImage image = clearImage(pixels);
  const std::vector<int> found = nearestLabels(flags, plane, at, mm, pixels);
  std::size_t pixel = 0;
  for (int row = 0; row < pixels.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < pixels.width(); ++column, ++pixel)
      if (found[pixel] != 0 && (row + column) % kEvery < kWide) line[column] = colour.rgba();
  }
  return image;
}

}  // namespace falciform
