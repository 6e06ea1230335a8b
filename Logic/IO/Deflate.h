#pragma once
#include <cstddef>
#include <cstdint>
#include <ostream>

namespace falciform {

enum class DeflateFormat { Gzip, Zlib };

/// Appends `count` bytes to `out`, deflated. The bytes written depend on the input alone (no time stamp).
/// Returns how many they are.
std::uint64_t writeDeflated(std::ostream& out, const void* bytes, std::size_t count, DeflateFormat format);

/// Several parts as one deflated stream, for a header followed by its voxels.
struct Bytes {
  const void* data = nullptr;
  std::size_t count = 0;
};
std::uint64_t writeDeflated(std::ostream& out, const Bytes* parts, std::size_t partCount,
                            DeflateFormat format);

/// Throws InputError ("disk full") if anything written to `out` was lost.
void checkWritten(std::ostream& out);

}  // namespace falciform
