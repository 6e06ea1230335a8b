#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "Logic/IO/OutputFile.h"

namespace falciform::commandline {

/// The files a command writes, all or none: each is written into a hidden folder in the result folder, laid
/// out as the result will be, and commit() moves them to their places. Without commit() nothing is left
/// behind, whatever went wrong.
class Outputs {
 public:
  Outputs() = default;
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Whether existing files may be replaced.
  Overwrite overwrite = Overwrite::Refuse;

  /// Says that `file` may be written, before any computation. Makes its folder. Throws InputError if the file
  /// exists and may not be replaced, or its folder cannot be written.
  void announce(const std::filesystem::path& file);
  /// Where to write the announced file now.
  [[nodiscard]] std::filesystem::path staged(const std::filesystem::path& file) const;
  /// Moves what was written to its place. An older file that was announced and not written again is removed,
  /// so that a folder never mixes two runs.
  void commit();
  /// commit() removes `file` when all else is in its place: it held what was done so far.
  void supersede(const std::filesystem::path& file) { superseded_.push_back(file); }
  /// Of the hidden folder of this process.
  [[nodiscard]] static std::string hiddenName();
  /// Files that commit() put in place.
  [[nodiscard]] const std::vector<std::filesystem::path>& written() const { return written_; }

 private:
  std::filesystem::path stagingFor(const std::filesystem::path& folder);
  /// Remembers which folders on the way to `folder` are not there yet, so that they can be taken away again.
  void noteMissing(const std::filesystem::path& folder);

  std::map<std::filesystem::path, std::filesystem::path>
      staging_;                              // folder -> where its files are written first
  std::vector<std::filesystem::path> made_;  // folders that were not there before, outermost first
  std::vector<std::filesystem::path> announced_, written_, superseded_;
};

}  // namespace falciform::commandline
