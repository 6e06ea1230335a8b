#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Logic/IO/MemoryFile.h"
#include "Testing/Logic/IO/VolumeBytes.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

constexpr int kMutantsPerFormat = 600;

std::string mutant(std::string bytes, std::mt19937& draw) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(draw()) % n; };
  // Half the changes hit the first 400 bytes, where the headers are.
  const auto somewhere = [&] {
    return below(draw() % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 400));
  };
  const std::size_t changes = 1 + below(6);
  for (std::size_t c = 0; c < changes && !bytes.empty(); ++c) {
    const std::size_t at = somewhere();
    switch (draw() % 8) {
      case 0:
        bytes[at] = static_cast<char>(draw());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << draw() % 8));
        break;
      case 2:
        bytes[at] = "0019-.()=: \n"[draw() % 12];
        break;  // what text headers are made of
      case 3:
        bytes.resize(at);
        break;
      case 4:
        bytes.insert(at, below(20), static_cast<char>(draw()));
        break;
      case 5:
        bytes.erase(at, below(20));
        break;
      case 6:
        bytes.insert(at, bytes.substr(somewhere(), below(40)));
        break;
      default:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at),
                      draw() % 2 ? "\xff\xff\xff\x7f" : "9999");
    }
  }
  return bytes;
}

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

LabelMap smallMap() {
  LabelMap map;
  map.size = {6, 5, 4};
  map.worldFromIndex.topLeftCorner<3, 3>() = Vector3d(-0.75, 0.75, 1.5).asDiagonal();
  for (int v = 0; v < 120; ++v) map.voxels.push_back(static_cast<std::uint16_t>(v % 9));
  return map;
}

std::string fileBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(VolumeFuzz, MutantsAreReadOrRefusedNeverWorse) {
  const TemporaryFolder folder;
  const LabelMap map = smallMap();
  unsigned seed = 20;
  for (const std::string extension : {".nii", ".nii.gz", ".nrrd", ".seg.nrrd", ".mha", ".mhd", ".nhdr"}) {
    writeLabelMap(folder / ("good" + extension), map, Overwrite::Replace);
    const std::string good = fileBytes(folder / ("good" + extension));
    std::mt19937 draw(++seed);
    MemoryFile memory(folder / ("mutant" + extension));
    int reads = 0;
    for (int m = 0; m < kMutantsPerFormat; ++m) {
      const std::string bytes = mutant(good, draw);
      const auto& file = memory.write(bytes);
      const std::size_t most = bytes.size() + good.size() + 10000;  // detached voxels count as well
      reads += readsOrRefuses([](const auto& path) { return readLabelMap(path); }, file, most);
      readsOrRefuses([](const auto& path) { return readImage(path); }, file, most);
    }
    EXPECT_GT(reads, 0) << extension << ": the mutants are all too far from a file";
    EXPECT_LT(reads, kMutantsPerFormat) << extension << ": the mutants are no mutants";
  }
}

TEST(VolumeFuzz, HandWrittenHeadersAndTextVoxelsAreNoWorse) {
  std::string text;
  for (int v = 1; v <= kGoldenVoxels; ++v) text += std::to_string(v) + " ";
  NiftiBytes nifti(true);
  nifti.qform(-1, {0, 1, 0}, {0, 0, 0}, {1, 1, 1});
  const std::pair<std::string, std::string> files[] = {
      {".nii", nifti.header() + goldenVoxels<std::uint8_t>()},
      {".nrrd",
       "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 1 2 3 4\nspace: RAS\nspace directions: none (1,0,0) "
       "(0,1,0) (0,0,1)\n"
       "kinds: list domain domain domain\nencoding: ascii\nbyte skip: 0\n\n" +
           text},
      {".mha",
       "NDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\nBinaryData = False\nElementDataFile = LOCAL\n" +
           text}};
  const TemporaryFolder folder;
  for (const auto& [extension, good] : files) {
    MemoryFile memory(folder / ("mutant" + extension));
    std::mt19937 draw(7);
    for (int m = 0; m < kMutantsPerFormat; ++m) {
      const std::string bytes = mutant(good, draw);
      readsOrRefuses([](const auto& path) { return readLabelMap(path); }, memory.write(bytes),
                     bytes.size() + good.size());
    }
  }
}

TEST(VolumeFuzz, EveryTruncationIsRefused) {
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
