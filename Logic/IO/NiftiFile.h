#pragma once
#include <filesystem>

#include "Logic/Core/Volume.h"
#include "Logic/IO/VolumeLayout.h"

namespace falciform {

/// Header of a NIfTI-1 or NIfTI-2 file (.nii, .nii.gz), either byte order. The voxel grid comes from the
/// sform, else from the qform with its qfac, else from the spacing alone (with a warning); RAS becomes LPS,
/// metres and micrometres mm. Throws InputError for a time series, colours, complex numbers, an ANALYZE or
/// two-file volume, and for values out of range.
[[nodiscard]] VolumeLayout readNiftiLayout(const std::filesystem::path& file);

/// Writes a NIfTI-1 file at `file` (deflated if `deflated`), sform RAS and, for perpendicular axes, the same
/// as qform. The format holds no more than 32767 voxels along an axis.
template <class T>
void writeNifti(const std::filesystem::path& file, const Volume<T>& volume, bool deflated);

/// The same for displacements: intent 1006 (displacement vectors), five dimensions, all first components,
/// then all second, then all third; vectors RAS.
void writeNiftiDisplacements(const std::filesystem::path& file, const DisplacementGrid& grid, bool deflated);

}  // namespace falciform
