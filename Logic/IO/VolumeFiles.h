#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "Logic/Core/Volume.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads a label map: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr, .seg.nrrd), MetaImage (.mha, .mhd). Any
/// stored number type whose values are whole numbers in 0..65535. Geometry (oblique, anisotropic,
/// left-handed, permuted) into LPS mm; units in the header honoured (NIfTI metres and micrometres, NRRD space
/// units). Warns where the header leaves the frame open or the extent looks like metres. Throws InputError
/// for missing, truncated or damaged files, time series, unknown types.
[[nodiscard]] Loaded<LabelMap> readLabelMap(const std::filesystem::path& file);
/// The same for a CT: any number type, slope and intercept applied.
[[nodiscard]] Loaded<Image> readImage(const std::filesystem::path& file);

/// Names that a `.seg.nrrd` gives its label values; empty for other files. Throws InputError as the readers
/// do.
[[nodiscard]] std::map<int, std::string> readLabelNames(const std::filesystem::path& file);

/// NIfTI (sform and qform, RAS, gzip by extension), NRRD (LPS, gzip) or MetaImage (LPS, zlib), by extension.
/// `.nhdr` and `.mhd` put the voxels beside the header, in NAME.raw.gz or NAME.zraw. Labels are stored as
/// 16-bit numbers, images as float32.
void writeLabelMap(const std::filesystem::path& file, const LabelMap& volume, Overwrite overwrite);
void writeImage(const std::filesystem::path& file, const Image& volume, Overwrite overwrite);

/// True for the extensions above.
[[nodiscard]] bool isVolumeFile(const std::filesystem::path& file);

}  // namespace falciform
