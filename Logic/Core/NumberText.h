#pragma once
#include <charconv>
#include <string>

namespace falciform {

/// The shortest text that reads back as the same number.
template <class Number>
[[nodiscard]] std::string numberText(Number value) {
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

}  // namespace falciform
