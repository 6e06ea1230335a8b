#include "Widgets/Views/SliceImage.h"

#include <algorithm>
#include <cmath>

namespace falciform {
namespace {

/// Grey of `value(index)`, for voxel coordinates inside the volume.
template <class T, class Grey>
QImage sampled(const Volume<T>& volume, SlicePlane plane, double at, const QRectF& mm, const QSize& pixels,
               Grey grey) {
  QImage image(pixels, QImage::Format_ARGB32);
  image.fill(Qt::transparent);
  if (volume.voxels.empty()) return image;
  const SliceAxes axes = axesOf(plane);
  const Eigen::Affine3d indexFromWorld(Matrix4d(volume.worldFromIndex.inverse()));
  for (int row = 0; row < pixels.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < pixels.width(); ++column) {
      const QPointF place(mm.left() + (column + 0.5) * mm.width() / pixels.width(),
                          mm.top() + (row + 0.5) * mm.height() / pixels.height());
      const Vector3d index = indexFromWorld * axes.inPatient(place, at);
      bool inside = true;
      for (int a = 0; a < 3; ++a) inside = inside && index[a] >= -0.5 && index[a] <= volume.size[a] - 0.5;
      if (!inside) continue;
      const int value = grey(index);
      line[column] = qRgb(value, value, value);
    }
  }
  return image;
}

int clampedTo(double index, int size) { return std::clamp(static_cast<int>(std::floor(index)), 0, size - 1); }

double interpolated(const Image& ct, const Vector3d& index) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    Vector3i voxel;
    for (int a = 0; a < 3; ++a) {
      const double inner = std::clamp(index[a], 0.0, ct.size[a] - 1.0);
      const int low = clampedTo(inner, ct.size[a]);
      const bool up = (corner >> a) & 1;
      weight *= up ? inner - low : 1 - (inner - low);
      voxel[a] = std::min(low + (up ? 1 : 0), ct.size[a] - 1);
    }
    if (weight > 0) sum += weight * static_cast<double>(ct.at(voxel.x(), voxel.y(), voxel.z()));
  }
  return sum;
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
  const double black = window.level - window.width / 2;
  return sampled(ct, plane, at, mm, pixels, [&](const Vector3d& index) {
    return static_cast<int>(
        std::lround(255 * std::clamp((interpolated(ct, index) - black) / window.width, 0.0, 1.0)));
  });
}

QImage sliceOf(const LabelMap& labels, SlicePlane plane, double at, const QRectF& mm, const QSize& pixels) {
  return sampled(labels, plane, at, mm, pixels, [&](const Vector3d& index) {
    const int label =
        labels.at(clampedTo(index.x() + 0.5, labels.size.x()), clampedTo(index.y() + 0.5, labels.size.y()),
                  clampedTo(index.z() + 0.5, labels.size.z()));
    return label == 0 ? 25 : 90 + (label - 1) * 45 % 135;
  });
}

}  // namespace falciform
