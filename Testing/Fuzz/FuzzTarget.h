#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace falciform::test {

/// A reader and a good file of it. `read` reads the file of this name, which is the good one or a mutant,
/// throws InputError if it does not like it, and something else if what it read is not sound.
struct FuzzTarget {
  std::string name;      ///< "dicom_jpeg2000"
  std::string fileName;  ///< "slice.dcm", relative to a folder of its own
  std::function<std::string(const std::filesystem::path& folder)>
      sample;  ///< the good file's bytes; may put others beside it
  std::function<void(const std::filesystem::path& file)> read;
};

/// Throws std::logic_error: a reader let something through.
void demand(bool sound, const std::string& what);

[[nodiscard]] std::vector<FuzzTarget> surfaceTargets();
/// Rasters, textures, depth frames, pictures.
[[nodiscard]] std::vector<FuzzTarget> scanTargets();
[[nodiscard]] std::vector<FuzzTarget> volumeTargets();
[[nodiscard]] std::vector<FuzzTarget> dicomTargets();
/// Landmarks, transforms, tables, JSON, tetrahedra, atlases.
[[nodiscard]] std::vector<FuzzTarget> otherTargets();
[[nodiscard]] std::vector<FuzzTarget> allTargets();

}  // namespace falciform::test
