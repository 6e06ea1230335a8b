#include "Logic/IO/Lzf.h"

#include <algorithm>

namespace falciform {

std::optional<std::string> unpackLzf(std::string_view packed, std::size_t size) {
  std::string whole;
  whole.reserve(size);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(packed[i]); };
  for (std::size_t at = 0; at < packed.size();) {
    const std::size_t code = byte(at++);
    if (code < 32) {  // so many + 1 bytes as they are
      const std::size_t count = code + 1;
      if (count > packed.size() - at || count > size - whole.size()) return std::nullopt;
      whole.append(packed.substr(at, count));
      at += count;
      continue;
    }
    // A copy: three bits of length, more in the next byte if all are set; thirteen bits of distance.
    std::size_t length = code >> 5;
    if (length == 7) {
      if (at >= packed.size()) return std::nullopt;
      length += byte(at++);
    }
    length += 2;
    if (at >= packed.size()) return std::nullopt;
    const std::size_t distance = ((code & 31) << 8 | byte(at++)) + 1;
    if (distance > whole.size() || length > size - whole.size()) return std::nullopt;
    for (; length > 0; --length) whole += whole[whole.size() - distance];  // may overlap itself
  }
  if (whole.size() != size) return std::nullopt;
  return whole;
}

std::string packLzfLiterally(std::string_view bytes) {
  constexpr std::size_t kMost = 32;
  std::string packed;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kMost, bytes.size()))) {
    packed += static_cast<char>(std::min(kMost, bytes.size()) - 1);
    packed += bytes.substr(0, kMost);
  }
  return packed;
}

}  // namespace falciform
