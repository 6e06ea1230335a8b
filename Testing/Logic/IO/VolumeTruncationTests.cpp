#include <gtest/gtest.h>

#include <fstream>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/MemoryFile.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

/// Reads, or throws InputError; what was read is whole and no larger than the file could hold.
template <class Read>
bool readsOrRefuses(Read read, const std::filesystem::path& file, std::size_t fileBytes) {
  try {
    const auto loaded = read(file);
    const auto& volume = loaded.value;
    EXPECT_EQ(volume.voxels.size(), static_cast<std::size_t>(volume.size.prod()));
    EXPECT_LE(volume.voxels.size(), 1032 * fileBytes) << "deflate cannot pack more";
    EXPECT_TRUE(volume.worldFromIndex.allFinite());
    EXPECT_GT(volume.voxelVolume(), 0);
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return false;
  }
}

std::string fileBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(VolumeTruncation, EveryTruncationIsRefused) {
  const TemporaryFolder folder;
  for (const std::string extension : {".nii", ".nii.gz", ".nrrd", ".mha"}) {
    writeLabelMap(folder / ("good" + extension), smallMap(), Overwrite::Replace);
    const std::string good = fileBytes(folder / ("good" + extension));
    MemoryFile memory(folder / ("cut" + extension));
    for (std::size_t length = 0; length < good.size(); ++length) {
      const auto& file = memory.write(good.substr(0, length));
      EXPECT_FALSE(readsOrRefuses([](const auto& path) { return readLabelMap(path); }, file, good.size()))
          << extension << " cut to " << length << " of " << good.size();
    }
  }
}

}  // namespace falciform::test
