#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace falciform {

/// Lengths of an array's dimensions, slowest first.
using Lengths = std::vector<std::uint64_t>;

/// Writes arrays into a new HDF5 file that leaves room for a seal (SealedFile.h). Names are paths, "mesh/x";
/// groups are made as needed. All is held in memory until close(), since HDF5 does not survive a disk that is
/// full. Throws InputError if the disk does not take it.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path& file);
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  /// Row-major.
  void numbers(const std::string& name, const double* values, const Lengths& lengths);
  void integers(const std::string& name, const std::vector<std::int32_t>& values, const Lengths& lengths);
  void texts(const std::string& name, const std::vector<std::string>& values);
  void text(const std::string& name, const std::string& value);
  /// A number or text among the file's own attributes.
  void attribute(const std::string& name, std::int32_t value);
  void attribute(const std::string& name, double value);
  void attribute(const std::string& name, const std::string& value);
  void close();

 private:
  std::filesystem::path file_;
  std::int64_t handle_ = -1;
};

/// Reads arrays of a file whose seal has been checked. Every function throws InputError that names file and
/// array where that is missing, of another type or shape, or larger than the file.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  /// Of as many dimensions as `lengths` has; those that are kAny there are found and filled in.
  static constexpr std::uint64_t kAny = ~std::uint64_t{0};
  [[nodiscard]] std::vector<double> numbers(const std::string& name, Lengths& lengths) const;
  [[nodiscard]] std::vector<std::int32_t> integers(const std::string& name, Lengths& lengths) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& name, std::uint64_t count) const;
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] double numberAttribute(const std::string& name) const;

 private:
  [[noreturn]] void fail(const std::string& name, const std::string& why) const;
  class Opened;
  std::filesystem::path file_;
  std::uint64_t bytes_ = 0;
  std::int64_t handle_ = -1;
};

}  // namespace falciform
