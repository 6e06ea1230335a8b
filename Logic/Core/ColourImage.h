#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Red, green, blue pixels, row 0 at the top: a picture, or the photograph that belongs to a scan.
struct ColourImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3

  [[nodiscard]] std::array<int, 3> at(int x, int y) const {
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

/// N x 2 places in an image: (0, 0) is its lower left corner, (1, 1) its upper right one. A row that is not
/// finite is a point on a seam, where the picture has no one place.
using TexturePlaces = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// The image's colours at N places, between pixel centres by bilinear interpolation; places outside take the
/// colour of the border, those that are not finite are black. The image must not be empty.
[[nodiscard]] Colours coloursAt(const ColourImage& image, const TexturePlaces& places);

}  // namespace falciform
