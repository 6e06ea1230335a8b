#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Surface.h"

namespace falciform::test {

/// A lumpy body of 162 points with everything that a Surface can hold.
[[nodiscard]] Surface fullSurface();

/// A new file each time: some disks flush a file that is emptied and written again, which takes milliseconds.
inline void put(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::remove(file);
  std::ofstream(file, std::ios::binary) << bytes;
}

/// The InputError's text of `work`, or "no error".
template <class Work>
[[nodiscard]] std::string refusalOf(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Number of entries in a folder.
[[nodiscard]] inline long entriesIn(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

}  // namespace falciform::test
