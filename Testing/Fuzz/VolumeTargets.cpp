#include <fstream>
#include <iterator>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Fuzz/FuzzTarget.h"
#include "Testing/Logic/IO/VolumeBytes.h"

namespace falciform::test {

namespace {

template <class T>
void demandSound(const Volume<T>& volume) {
  demand(volume.voxels.size() == volume.offset(0, 0, volume.size.z()), "voxels are missing");
  demand(volume.worldFromIndex.allFinite() && volume.voxelVolume() > 0, "a geometry that cannot be");
}

void readSound(const std::filesystem::path& file) {
  demandSound(readImage(file).value);
  demandSound(readNamedLabels(file).value.map);
}

std::string asciiNrrd() {
  std::string text =
      "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 1 2 3 4\nspace: RAS\nspace directions: none (1,0,0) "
      "(0,1,0) (0,0,1)\nkinds: list domain domain domain\nencoding: ascii\nbyte skip: 0\n\n";
  for (int v = 1; v <= kGoldenVoxels; ++v) text += std::to_string(v) + " ";
  return text;
}

std::string asciiMetaImage() {
  std::string text =
      "NDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\nBinaryData = False\nElementDataFile = LOCAL\n";
  for (int v = 1; v <= kGoldenVoxels; ++v) text += std::to_string(v) + " ";
  return text;
}

std::string bigEndianNifti() {
  NiftiBytes nifti(true);
  nifti.qform(-1, {0, 1, 0}, {0, 0, 0}, {1, 1, 1});
  return nifti.header() + goldenVoxels<std::uint8_t>();
}

}  // namespace

std::vector<FuzzTarget> volumeTargets() {
  std::vector<FuzzTarget> targets;
  for (const std::string extension : {".nii", ".nii.gz", ".nrrd", ".seg.nrrd", ".mha", ".mhd", ".nhdr"}) {
    std::string name = "volume" + extension;
    for (char& letter : name) letter = letter == '.' ? '_' : letter;
    targets.push_back({name, "v" + extension,
                       [extension](const std::filesystem::path& folder) {
                         // A detached header names its voxels' file, so the good one keeps its place.
                         const std::filesystem::path good = folder / ("good" + extension);
                         writeLabelMap(good, smallMap(), Overwrite::Replace);
                         std::ifstream in(good, std::ios::binary);
                         return std::string{std::istreambuf_iterator<char>(in), {}};
                       },
                       readSound});
  }
  using Path = const std::filesystem::path&;
  targets.push_back({"volume_ascii_nrrd", "v.nrrd", [](Path) { return asciiNrrd(); }, readSound});
  targets.push_back({"volume_ascii_mha", "v.mha", [](Path) { return asciiMetaImage(); }, readSound});
  targets.push_back({"volume_big_endian_nii", "v.nii", [](Path) { return bigEndianNifti(); }, readSound});
  return targets;
}

}  // namespace falciform::test
