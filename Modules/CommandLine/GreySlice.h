#pragma once
#include <array>
#include <cstdint>

#include "Logic/Core/Volume.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::commandline {

using PixelColour = std::array<std::uint8_t, 3>;

/// The part of an axial cut that a picture shows, as radiologists look at it: the patient's right at the
/// left, front at the top.
struct SliceFrame {
  int width = 560, height = 440;  ///< pixels
  double z = 0, mmPerPixel = 1;
  Vector3d middle = Vector3d::Zero();

  [[nodiscard]] Vector3d place(double column, double row) const {
    return {middle.x() + (column - width / 2.0) * mmPerPixel, middle.y() + (row - height / 2.0) * mmPerPixel,
            z};
  }
  [[nodiscard]] Eigen::Vector2d pixel(const Vector3d& mm) const {
    return {(mm.x() - middle.x()) / mmPerPixel + width / 2.0,
            (mm.y() - middle.y()) / mmPerPixel + height / 2.0};
  }
};

/// The CT in the usual window for a liver; black outside of it.
[[nodiscard]] RenderedImage greySlice(const Image& ct, const SliceFrame& frame);

/// Two pixels wide and high; nothing outside the picture.
void drawDot(RenderedImage& image, int x, int y, const PixelColour& colour);

}  // namespace falciform::commandline
