#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "Logic/IO/VolumeLayout.h"

struct z_stream_s;

namespace falciform {

/// The bytes of an ordinary file from an offset on, inflated on the way if they are deflated (gzip of any
/// number of members, or zlib). Holds one block at a time, so that no header can make it take memory that the
/// file does not fill.
class ByteReader {
 public:
  /// Throws InputError if the file is missing, no ordinary file, unreadable or shorter than `offset`.
  ByteReader(const std::filesystem::path& file, std::uint64_t offset, Packing packing);
  ~ByteReader();
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  /// Fills `into`; returns fewer bytes only at the end of the data. Throws InputError if deflated data is
  /// damaged.
  std::size_t read(void* into, std::size_t count);
  /// The same for bytes that nobody wants; returns how many there were.
  std::uint64_t skip(std::uint64_t count);
  /// True once the end of deflated data was read and its check sum was right; always true for other data.
  [[nodiscard]] bool complete() const { return packing_ != Packing::Deflated || finished_; }
  /// No more bytes than these can come: the file's own, or as many as deflate packs into them at best.
  [[nodiscard]] std::uint64_t mostBytes() const;

 private:
  std::size_t readFile(void* into, std::size_t count);
  std::size_t inflateInto(void* into, std::size_t count);
  bool refill();

  std::filesystem::path path_;
  std::ifstream in_;
  std::uint64_t bytes_ = 0;
  Packing packing_;
  std::vector<unsigned char> block_;
  std::unique_ptr<z_stream_s> stream_;
  bool finished_ = false;
};

/// True if the file begins with gzip's two bytes, whatever its name.
[[nodiscard]] bool isGzip(const std::filesystem::path& file);

}  // namespace falciform
