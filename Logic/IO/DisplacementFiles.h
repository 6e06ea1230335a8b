#pragma once
#include <filesystem>

#include "Logic/Core/Volume.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Writes displacements in the resampling direction (see DisplacementGrid), as ITK and 3D Slicer read them:
/// NRRD (.nrrd: LPS, gzip) or NIfTI (.nii, .nii.gz: intent 1006, vectors and grid RAS), by extension. Loaded
/// in 3D Slicer as a transform and applied to what the vectors lead back to, it moves that to where it is.
/// Throws InputError for another extension and for a grid that the format cannot hold.
void writeDisplacements(const std::filesystem::path& file, const DisplacementGrid& grid, Overwrite overwrite);

/// True for the extensions above.
[[nodiscard]] bool isDisplacementFile(const std::filesystem::path& file);

}  // namespace falciform
