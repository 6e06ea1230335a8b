#pragma once
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Volume.h"

namespace falciform::test {

// Volume files built byte by byte, with no help from the writers under test. Every golden volume has 2 x 3 x
// 4 voxels that hold 1..24 in file order.

inline constexpr int kGoldenVoxels = 24;

/// `value` as the bytes of a Stored, in the given order.
template <class Stored>
std::string bytesOfNumber(double value, bool bigEndian) {
  const auto stored = static_cast<Stored>(value);
  std::string bytes(sizeof stored, '\0');
  std::memcpy(bytes.data(), &stored, sizeof stored);
  if (bigEndian != (std::endian::native == std::endian::big)) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

template <class Stored>
std::string goldenVoxels(bool bigEndian = false) {
  std::string bytes;
  for (int v = 1; v <= kGoldenVoxels; ++v) bytes += bytesOfNumber<Stored>(v, bigEndian);
  return bytes;
}

/// The golden voxels as unsigned char, packed by Python's gzip and zlib.
[[nodiscard]] std::string goldenGzip();
[[nodiscard]] std::string goldenZlib();

std::filesystem::path writeBytes(const std::filesystem::path& file, const std::string& bytes);

/// A NIfTI-1 header of a golden volume (uint8, spacing 1, mm, no sform, no qform), to be changed field by
/// field.
class NiftiBytes {
 public:
  explicit NiftiBytes(bool bigEndian = false);
  template <class Stored>
  NiftiBytes& put(std::size_t offset, double value) {
    const std::string bytes = bytesOfNumber<Stored>(value, bigEndian_);
    header_.replace(offset, bytes.size(), bytes);
    return *this;
  }
  NiftiBytes& sform(const Eigen::Matrix<double, 3, 4>& ras);
  NiftiBytes& qform(double qfac, const Vector3d& bcd, const Vector3d& offset, const Vector3d& spacing);
  NiftiBytes& type(int code, int bits);
  [[nodiscard]] const std::string& header() const { return header_; }

 private:
  bool bigEndian_;
  std::string header_;
};

/// The InputError's text that `work` throws; empty, with a failed test, if it throws none or one of several
/// lines.
template <class Work>
std::string refusalOf(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << "an error is one line: " << text;
    return text;
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

/// True if the volume holds 1..24 in file order.
template <class T>
bool holdsGoldenVoxels(const Volume<T>& volume) {
  if (volume.size != Vector3i(2, 3, 4) || volume.voxels.size() != kGoldenVoxels) return false;
  for (int v = 0; v < kGoldenVoxels; ++v)
    if (volume.voxels[static_cast<std::size_t>(v)] != static_cast<T>(v + 1)) return false;
  return true;
}

/// True if some warning contains `text`.
[[nodiscard]] bool warns(const std::vector<std::string>& warnings, const std::string& text);

/// 6 x 5 x 4 voxels of 0.75 x 0.75 x 1.5 mm, the first axis turned round, that hold 0..8 again and again.
[[nodiscard]] LabelMap smallMap();

}  // namespace falciform::test
