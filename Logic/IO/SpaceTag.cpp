#include <algorithm>
#include <cctype>

#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace

std::optional<std::string> spaceTagIn(std::string_view comment) {
  constexpr std::string_view kKey = "SPACE=";
  const std::size_t at = comment.find(kKey);
  if (at == std::string_view::npos) return std::nullopt;
  std::string value;
  for (const char c : comment.substr(at + kKey.size())) {
    if (c == ';' || static_cast<unsigned char>(c) < ' ' || value.size() == 64) break;
    value += c;
  }
  while (!value.empty() && value.back() == ' ') value.pop_back();
  if (value.empty()) return std::nullopt;
  // 3D Slicer may go on behind the tag: "SPACE=RAS anything".
  const std::string first = upper(value.substr(0, 3));
  const bool ends = value.size() == 3 || value[3] == ' ';
  if (ends && (first == "LPS" || first == "RAS")) return first;
  return value;
}

std::string spaceTagOf(const Surface& surface) {
  std::string tag = "SPACE=" + surface.frame;
  for (char& c : tag)
    if (static_cast<unsigned char>(c) < ' ' || c == ';') c = ' ';
  return tag;
}

}  // namespace falciform
