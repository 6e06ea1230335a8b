#pragma once
#include <vtkRenderWindow.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Red, green, blue pixels, row 0 at the top.
struct RenderedImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3

  [[nodiscard]] std::array<int, 3> at(int x, int y) const {
    const std::size_t i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

/// What the window shows now, without rendering again.
[[nodiscard]] RenderedImage grab(vtkRenderWindow* window);

/// Half the size, each pixel the mean of four: how a picture drawn twice as large becomes smooth.
[[nodiscard]] RenderedImage halved(const RenderedImage& image);

/// Writes a PNG whose text chunk says that it is for research use only. Throws InputError as writeFile does.
void savePng(const RenderedImage& image, const std::filesystem::path& file, Overwrite overwrite);

/// Reads a PNG, transparency dropped. Throws InputError if the file is missing or no PNG.
[[nodiscard]] RenderedImage readPng(const std::filesystem::path& file);

}  // namespace falciform
