#include "Modules/CommandLine/GreySlice.h"

#include <algorithm>
#include <cmath>

namespace falciform::commandline {
namespace {

/// Hounsfield units: the usual window for a liver.
constexpr double kLevel = 80, kWindow = 400;

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

}  // namespace

RenderedImage greySlice(const Image& ct, const SliceFrame& frame) {
  RenderedImage image{.width = frame.width, .height = frame.height, .rgb = {}};
  image.rgb.assign(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height) * 3, 0);
  const Matrix4d indexFromWorld = ct.worldFromIndex.inverse();
  std::size_t i = 0;
  for (int row = 0; row < frame.height; ++row)
    for (int column = 0; column < frame.width; ++column, i += 3) {
      const double value = valueAt(ct, indexFromWorld, frame.place(column + 0.5, row + 0.5));
      if (std::isnan(value)) continue;
      const double grey = std::clamp((value - kLevel) / kWindow + 0.5, 0.0, 1.0);
      std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(i), 3,
                  static_cast<std::uint8_t>(std::lround(255 * grey)));
    }
  return image;
}

void drawDot(RenderedImage& image, int left, int top, const PixelColour& colour) {
  for (int y = std::max(0, top); y < std::min(image.height, top + 2); ++y)
    for (int x = std::max(0, left); x < std::min(image.width, left + 2); ++x) {
      const std::size_t pixel = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                     static_cast<std::size_t>(x));
      std::copy(colour.begin(), colour.end(), image.rgb.begin() + static_cast<std::ptrdiff_t>(pixel));
    }
}

}  // namespace falciform::commandline
