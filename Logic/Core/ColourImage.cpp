#include "Logic/Core/ColourImage.h"

#include <algorithm>
#include <cmath>

namespace falciform {

Colours coloursAt(const ColourImage& image, const TexturePlaces& places) {
  Colours colours = Colours::Zero(places.rows(), 3);
  for (Index i = 0; i < places.rows(); ++i) {
    if (!places.row(i).allFinite()) continue;
    // Pixel (0, 0) is the upper left one, and its centre lies half a pixel inside.
    const double x =
        std::clamp(static_cast<double>(places(i, 0)) * image.width - 0.5, 0.0, image.width - 1.0);
    const double y =
        std::clamp((1.0 - static_cast<double>(places(i, 1))) * image.height - 0.5, 0.0, image.height - 1.0);
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, image.width - 1), bottom = std::min(top + 1, image.height - 1);
    const double u = x - left, v = y - top;
    const auto a = image.at(left, top), b = image.at(right, top), c = image.at(left, bottom),
               d = image.at(right, bottom);
    for (std::size_t k = 0; k < 3; ++k)
      colours(i, static_cast<Index>(k)) = static_cast<std::uint8_t>(
          std::lround((1 - v) * ((1 - u) * a[k] + u * b[k]) + v * ((1 - u) * c[k] + u * d[k])));
  }
  return colours;
}

}  // namespace falciform
