#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "Logic/Core/Volume.h"
#include "Logic/IO/VolumeLayout.h"

namespace falciform {

/// Header of a NRRD file, attached (.nrrd, .seg.nrrd) or detached (.nhdr). `space` and `space directions`
/// give the grid (any anatomical space, axes in any order); `spacings` alone are taken as LPS with a warning.
/// A list axis of one entry is dropped. Throws InputError for time series, colours, segments in several
/// layers, and encodings other than raw, gzip and ascii.
///
/// 3D Slicer writes `Segmentation_ReferenceImageExtentOffset`: where a cropped segmentation's first voxel
/// lies in the grid of the image that it was drawn on. `space origin` is that of the cropped grid already, so
/// the key does not move anything.
[[nodiscard]] VolumeLayout readNrrdLayout(const std::filesystem::path& file);

/// Names of label values that a `.seg.nrrd` header gives (SegmentN_LabelValue, SegmentN_Name); empty for any
/// other NRRD.
[[nodiscard]] std::map<int, std::string> readNrrdSegmentNames(const std::filesystem::path& file);

/// Writes the voxels (gzip) behind a header at `file`, LPS. `segments`: with 3D Slicer's keys that make it a
/// segmentation.
template <class T>
void writeNrrd(const std::filesystem::path& file, const Volume<T>& volume, bool segments);

/// The detached header that goes with a gzip file of the voxels named `dataName` in the same folder.
template <class T>
void writeNrrdHeader(const std::filesystem::path& file, const Volume<T>& volume, const std::string& dataName);

/// The same for displacements: four axes, the vector's components (LPS) first; 3D Slicer's key says that they
/// are for resampling.
void writeNrrdDisplacements(const std::filesystem::path& file, const DisplacementGrid& grid);

}  // namespace falciform
