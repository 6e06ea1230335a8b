#pragma once
#include <filesystem>
#include <string>

#include "Logic/Core/Types.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads a rigid transform that maps source mm to target mm: ITK `.tfm` (stored inverse, LPS: see
/// writeTransform), `.txt` (4 x 4, row-major) or
/// `.json`. Throws InputError if it is not rigid (R^T R = 1, det = +1 within 1e-5, then made exact) or
/// damaged.
[[nodiscard]] Isometry3d readTransform(const std::filesystem::path& file);

/// Writes `targetFromSource` by extension. `.txt`: the 4 x 4 itself, row-major, with a comment line that says
/// in words what it maps
/// (`direction`, e.g. "maps pre-op LPS mm to scan mm"). `.json`: matrix, direction, units. `.tfm`: ITK
/// AffineTransform_double_3_3 in LPS, which by ITK's resampling convention maps fixed to moving, so it holds
/// the *inverse*: loaded in 3D Slicer as a linear transform and applied to the source it moves the source
/// onto the target.
void writeTransform(const std::filesystem::path& file, const Isometry3d& targetFromSource,
                    const std::string& direction, Overwrite overwrite);

}  // namespace falciform
