#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "Logic/Core/ColourImage.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Distances along a camera's axis, row 0 at the top, in the camera's own units; 0: none.
struct DepthImage {
  int width = 0, height = 0;
  std::vector<std::uint16_t> depth;  ///< width * height
};

/// Reads a PNG or JPEG, by its content; grey becomes three equal colours, transparency is dropped, 16 bits
/// become 8. Throws InputError if the file is missing, of another kind, damaged, or announces more pixels
/// than its bytes could hold.
[[nodiscard]] ColourImage readColourImage(const std::filesystem::path& file);

/// Reads a PNG of one channel and 16 bits, the values as they stand. Throws as above.
[[nodiscard]] DepthImage readDepthImage(const std::filesystem::path& file);

/// Whether the file begins as a PNG of one channel and 16 bits, which a photograph never is.
[[nodiscard]] bool isDepthImage(const std::filesystem::path& file);

/// Writes a PNG with text chunks (keyword, text). Throws InputError as writeFile does.
void writePng(const std::filesystem::path& file, const ColourImage& image, Overwrite overwrite,
              const std::vector<std::pair<std::string, std::string>>& texts = {});
/// The same for depths.
void writePng(const std::filesystem::path& file, const DepthImage& image, Overwrite overwrite);

}  // namespace falciform
