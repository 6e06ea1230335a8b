#include "Logic/IO/VolumeFiles.h"

#include <fstream>

#include "Logic/IO/Deflate.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/MetaImageFile.h"
#include "Logic/IO/NiftiFile.h"
#include "Logic/IO/NrrdFile.h"
#include "Logic/IO/VoxelReading.h"

namespace falciform {

namespace {

enum class Format { Nifti, NiftiGz, Nrrd, SegNrrd, NrrdDetached, MetaImage, MetaImageDetached, None };

Format formatOf(const std::filesystem::path& file) {
  const std::string name = lowerCase(file.filename().string());
  if (name.ends_with(".nii")) return Format::Nifti;
  if (name.ends_with(".nii.gz")) return Format::NiftiGz;
  if (name.ends_with(".seg.nrrd")) return Format::SegNrrd;
  if (name.ends_with(".nrrd")) return Format::Nrrd;
  if (name.ends_with(".nhdr")) return Format::NrrdDetached;
  if (name.ends_with(".mha")) return Format::MetaImage;
  if (name.ends_with(".mhd")) return Format::MetaImageDetached;
  return Format::None;
}

[[noreturn]] void refuseExtension(const std::filesystem::path& file) {
  refuseVolume(file, "no volume format has the extension " + inQuotes(file.extension().string()) +
                         "; use .nii, .nii.gz, .nrrd, .seg.nrrd, .nhdr, .mha, .mhd or a DICOM folder");
}

VolumeLayout readLayout(const std::filesystem::path& file) {
  switch (formatOf(file)) {
    case Format::Nifti:
    case Format::NiftiGz:
      return readNiftiLayout(file);
    case Format::Nrrd:
    case Format::SegNrrd:
    case Format::NrrdDetached:
      return readNrrdLayout(file);
    case Format::MetaImage:
    case Format::MetaImageDetached:
      return readMetaImageLayout(file);
    case Format::None:
      break;
  }
  refuseExtension(file);
}

/// "liver.mhd" and "liver.zraw": the voxels first, so that a header never names a file that is not there.
template <class T, class WriteHeader>
void writeDetached(const std::filesystem::path& file, const Volume<T>& volume, Overwrite overwrite,
                   const char* extension, DeflateFormat format, WriteHeader&& writeHeader) {
  std::error_code ignored;
  if (overwrite == Overwrite::Refuse && std::filesystem::exists(file, ignored))
    refuseVolume(file, "exists already; give --force to replace it, or choose another name");
  std::filesystem::path data = file;
  data.replace_extension(extension);
  std::uint64_t bytes = 0;
  writeFile(data, overwrite, [&](const std::filesystem::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    bytes = writeDeflated(out, volume.voxels.data(), volume.voxels.size() * sizeof(T), format);
    checkWritten(out);
  });
  writeFile(file, overwrite, [&](const std::filesystem::path& temporary) {
    writeHeader(temporary, data.filename().string(), bytes);
  });
}

template <class T>
void checkForWriting(const std::filesystem::path& file, const Volume<T>& volume) {
  VolumeLayout layout;
  layout.file = file;
  layout.size = checkedSize(file, volume.size.x(), volume.size.y(), volume.size.z());
  layout.worldFromIndex = volume.worldFromIndex;
  checkGeometry(layout);
  const Format format = formatOf(file);
  if ((format == Format::Nifti || format == Format::NiftiGz) && volume.size.maxCoeff() > 32767)
    refuseVolume(file, "the volume has " + std::to_string(volume.size.maxCoeff()) +
                           " voxels along one axis, NIfTI holds 32767; save it as .nrrd");
}

template <class T>
void writeVolume(const std::filesystem::path& file, const Volume<T>& volume, Overwrite overwrite) {
  using Path = const std::filesystem::path&;
  checkForWriting(file, volume);
  switch (formatOf(file)) {
    case Format::Nifti:
      return writeFile(file, overwrite, [&](Path p) { writeNifti(p, volume, false); });
    case Format::NiftiGz:
      return writeFile(file, overwrite, [&](Path p) { writeNifti(p, volume, true); });
    case Format::Nrrd:
      return writeFile(file, overwrite, [&](Path p) { writeNrrd(p, volume, false); });
    case Format::SegNrrd:
      return writeFile(file, overwrite, [&](Path p) { writeNrrd(p, volume, true); });
    case Format::MetaImage:
      return writeFile(file, overwrite, [&](Path p) { writeMetaImage(p, volume); });
    case Format::NrrdDetached:
      return writeDetached(
          file, volume, overwrite, ".raw.gz", DeflateFormat::Gzip,
          [&](Path p, const std::string& data, std::uint64_t) { writeNrrdHeader(p, volume, data); });
    case Format::MetaImageDetached:
      return writeDetached(file, volume, overwrite, ".zraw", DeflateFormat::Zlib,
                           [&](Path p, const std::string& data, std::uint64_t bytes) {
                             writeMetaImageHeader(p, volume, data, bytes);
                           });
    case Format::None:
      refuseExtension(file);
  }
}

}  // namespace

Loaded<NamedLabels> readNamedLabels(const std::filesystem::path& file, const std::string& series,
                                    const Progress& progress) {
  if (formatOf(file) == Format::None && isDicom(file))
    return readChosenLabels(listDicom(file, progress.part(0, 0.2)), series, progress.part(0.2, 1));
  Loaded<LabelMap> labels = readLabels(readLayout(file));
  return {{std::move(labels.value), readLabelNames(file)}, std::move(labels.warnings)};
}

Loaded<LabelMap> readLabelMap(const std::filesystem::path& file, const std::string& series) {
  Loaded<NamedLabels> named = readNamedLabels(file, series);
  return {std::move(named.value.map), std::move(named.warnings)};
}

Loaded<Image> readImage(const std::filesystem::path& file, const std::string& series) {
  if (formatOf(file) == Format::None && isDicom(file))
    return readDicomImage(chooseSeries(listDicom(file), series));
  return readIntensities(readLayout(file));
}

std::map<int, std::string> readLabelNames(const std::filesystem::path& file) {
  if (formatOf(file) == Format::None && isDicom(file)) return readNamedLabels(file).value.names;
  return formatOf(file) == Format::SegNrrd ? readNrrdSegmentNames(file) : std::map<int, std::string>{};
}

void writeLabelMap(const std::filesystem::path& file, const LabelMap& volume, Overwrite overwrite) {
  writeVolume(file, volume, overwrite);
}
void writeImage(const std::filesystem::path& file, const Image& volume, Overwrite overwrite) {
  writeVolume(file, volume, overwrite);
}

bool isVolumeFile(const std::filesystem::path& file) { return formatOf(file) != Format::None; }
bool isVolume(const std::filesystem::path& path) { return isVolumeFile(path) || isDicom(path); }

}  // namespace falciform
