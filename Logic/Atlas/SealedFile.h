#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace falciform {

/// Our HDF5 files begin with a head of kSealBytes of text (HDF5 calls it a user block; its readers skip it)
/// that holds what the file is, its version, its size and a checksum of the rest. So a damaged, cut or
/// foreign file is known before HDF5 sees a byte of it: the library is not made for hostile ones.
inline constexpr std::size_t kSealBytes = 512;

/// Writes the head of a finished file whose first kSealBytes are free. Throws InputError if that fails.
void sealFile(const std::filesystem::path& file, const std::string& kind, int version);

/// What is wrong with a file, in one line: missing, of another kind, newer than `newest`, cut off, or changed
/// since it was written; empty if nothing is.
[[nodiscard]] std::string sealFault(const std::filesystem::path& file, const std::string& kind, int newest);

/// Throws InputError that says so.
void checkSeal(const std::filesystem::path& file, const std::string& kind, int newest);

/// A running checksum (FNV-1a of 64 bits, over words of 8 bytes): against accidents, not against forgers.
class Checksum {
 public:
  void add(const void* bytes, std::size_t count);
  template <class T>
  void addRange(const T* first, std::size_t count) {
    add(first, count * sizeof(T));
  }
  [[nodiscard]] std::string text() const;  ///< 16 hexadecimal digits

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace falciform
