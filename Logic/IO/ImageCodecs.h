#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "Logic/IO/ImageFiles.h"

namespace falciform {

// Pictures from bytes and back, by libpng and libjpeg. `name` is for messages. Inside Logic/IO only.

[[nodiscard]] bool isPng(std::string_view bytes);
[[nodiscard]] ColourImage decodePng(const std::string& bytes, const std::string& name);
[[nodiscard]] DepthImage decodeDepthPng(const std::string& bytes, const std::string& name);
[[nodiscard]] ColourImage decodeJpeg(const std::string& bytes, const std::string& name);
[[nodiscard]] std::string encodePng(const ColourImage& image,
                                    const std::vector<std::pair<std::string, std::string>>& texts);
[[nodiscard]] std::string encodePng(const DepthImage& image);

/// Throws InputError for no pixels, or more than `bytes` could hold: deflate packs at most 1032 to one, and a
/// JPEG of nothing but flat blocks is not larger.
void checkPixels(double width, double height, std::size_t bytes, const std::string& name);

}  // namespace falciform
