#pragma once
#include <filesystem>
#include <string>

#include "Logic/Core/Volume.h"
#include "Logic/IO/VolumeLayout.h"

namespace falciform {

/// Header of a MetaImage: voxels behind it (.mha) or in another file (.mhd). World is LPS. Each *row* of
/// `TransformMatrix` is the direction of one index axis, as ITK writes and reads it. Throws InputError for
/// time series, colours and voxels in several files.
[[nodiscard]] VolumeLayout readMetaImageLayout(const std::filesystem::path& file);

/// Writes the header with the voxels (zlib) behind it.
template <class T>
void writeMetaImage(const std::filesystem::path& file, const Volume<T>& volume);

/// The header that goes with a file of `dataBytes` zlib bytes named `dataName` in the same folder.
template <class T>
void writeMetaImageHeader(const std::filesystem::path& file, const Volume<T>& volume,
                          const std::string& dataName, std::uint64_t dataBytes);

}  // namespace falciform
