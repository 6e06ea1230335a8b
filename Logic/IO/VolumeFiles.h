#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Volume.h"
#include "Logic/IO/DicomSeries.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads a label map: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr, .seg.nrrd), MetaImage (.mha, .mhd), or a
/// DICOM folder or file (DicomSeries.h). Any stored number type whose values are whole numbers in 0..65535.
/// Geometry (oblique, anisotropic, left-handed, permuted) into LPS mm; units in the header honoured (NIfTI
/// metres and micrometres, NRRD space units). Warns where the header leaves the frame open or the extent
/// looks like metres. `series` chooses among several DICOM series, by number or code (chooseSeries); other
/// files ignore it. Throws InputError for missing, truncated or damaged files, time series, unknown types.
[[nodiscard]] Loaded<LabelMap> readLabelMap(const std::filesystem::path& file,
                                            const std::string& series = {});
/// The same for a CT: any number type, slope and intercept applied.
[[nodiscard]] Loaded<Image> readImage(const std::filesystem::path& file, const std::string& series = {});

/// A label map with the names that a `.seg.nrrd`, a DICOM SEG or the masks of a DICOM folder give its labels;
/// no names for other files.
[[nodiscard]] Loaded<NamedLabels> readNamedLabels(const std::filesystem::path& file,
                                                  const std::string& series = {},
                                                  const Progress& progress = {});
/// The names alone.
[[nodiscard]] std::map<int, std::string> readLabelNames(const std::filesystem::path& file);

/// NIfTI (sform and qform, RAS, gzip by extension), NRRD (LPS, gzip) or MetaImage (LPS, zlib), by extension.
/// `.nhdr` and `.mhd` put the voxels beside the header, in NAME.raw.gz or NAME.zraw. Labels are stored as
/// 16-bit numbers, images as float32.
void writeLabelMap(const std::filesystem::path& file, const LabelMap& volume, Overwrite overwrite);
void writeImage(const std::filesystem::path& file, const Image& volume, Overwrite overwrite);

/// True for the extensions above.
[[nodiscard]] bool isVolumeFile(const std::filesystem::path& file);
/// True for these, and for DICOM files and folders, which are known by their content.
[[nodiscard]] bool isVolume(const std::filesystem::path& fileOrFolder);

}  // namespace falciform
