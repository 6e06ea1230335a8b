#include "Logic/Acquisition/LabColour.h"

#include <array>
#include <cmath>

namespace falciform {

namespace {

/// Linear light of an 8-bit sRGB value (IEC 61966-2-1).
std::array<double, 256> linearLight() {
  std::array<double, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = static_cast<double>(i) / 255;
    table[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  }
  return table;
}

/// CIE 15: a cube root with a straight beginning.
double perceived(double t) {
  constexpr double kSmall = 216.0 / 24389, kSlope = 24389.0 / 27;
  return t > kSmall ? std::cbrt(t) : (kSlope * t + 16) / 116;
}

}  // namespace

Points labOf(const Colours& colours) {
  static const std::array<double, 256> kLight = linearLight();
  Matrix3d xyzFromRgb;
  xyzFromRgb << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
      0.9503041;
  const Vector3d white = xyzFromRgb.rowwise().sum();
  Points lab(colours.rows(), 3);
  for (Index i = 0; i < colours.rows(); ++i) {
    const Vector3d rgb(kLight[colours(i, 0)], kLight[colours(i, 1)], kLight[colours(i, 2)]);
    const Vector3d f = (xyzFromRgb * rgb).cwiseQuotient(white).unaryExpr(&perceived);
    lab.row(i) << 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2]);
  }
  return lab;
}

}  // namespace falciform
