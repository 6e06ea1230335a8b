#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads a surface or scan: VTP, VTK legacy, STL, PLY, OBJ, XYZ, CSV (by extension, any case). Space tags are
/// honoured (RAS is turned into LPS); without a tag LPS is assumed, with a warning. Warns of a bounding box
/// that looks like metres or micrometres. Throws InputError for a missing, truncated or damaged file, an
/// empty one, non-finite or absurd (> 1e6 mm) coordinates.
[[nodiscard]] Loaded<Surface> readSurface(const std::filesystem::path& file);

/// Writes VTP, VTK (legacy 4.2), STL, PLY or OBJ by extension, with its space tag. VTP and VTK keep all
/// arrays; PLY keeps colours, normals and Patch; OBJ and STL keep geometry.
void writeSurface(const std::filesystem::path& file, const Surface& surface, Overwrite overwrite);

/// The surface with its coordinates times `factor`, for files in metres (1000) or micrometres (0.001); arrays
/// stay as they are.
[[nodiscard]] Surface scaled(const Surface& surface, double factor);

/// The extensions that readSurface takes, lower case with the dot.
[[nodiscard]] const std::vector<std::string>& surfaceExtensions();

}  // namespace falciform
