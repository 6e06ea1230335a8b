#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads a surface or scan: VTP, VTK legacy, STL, PLY, OBJ, PCD, XYZ, CSV (by extension, any case), and depth
/// frames (DepthFrames.h). Rasters are joined to triangles. Where points have texture coordinates, the image
/// that the file names, or FILE_texture.png, FILE.png or FILE.jpg beside it, gives texture and colours. Space
/// tags are honoured (RAS is turned into LPS); without a tag LPS is assumed, with a warning. Warns of a
/// bounding box that looks like metres or micrometres. Throws InputError for a missing, truncated or damaged
/// file, an empty one, non-finite or absurd (> 1e6 mm) coordinates.
[[nodiscard]] Loaded<Surface> readSurface(const std::filesystem::path& file);

/// Writes VTP, VTK (legacy 4.2), STL, PLY or OBJ by extension, with its space tag. VTP and VTK keep all
/// arrays; PLY keeps colours, normals and Patch; OBJ and STL keep geometry. All but STL keep a texture: see
/// filesBeside.
void writeSurface(const std::filesystem::path& file, const Surface& surface, Overwrite overwrite);

/// What writeSurface writes beside `file` for a surface with texture: FILE_texture.png, and FILE.mtl of an
/// OBJ.
[[nodiscard]] std::vector<std::filesystem::path> filesBeside(const std::filesystem::path& file);

/// The surface with its coordinates times `factor`, for files in metres (1000) or micrometres (0.001); arrays
/// stay as they are.
[[nodiscard]] Surface scaled(const Surface& surface, double factor);

/// The extensions that readSurface takes, lower case with the dot; beside these, PNG files of depths.
[[nodiscard]] const std::vector<std::string>& surfaceExtensions();

/// Whether readSurface takes this file: by its extension, a PNG by its head.
[[nodiscard]] bool isSurfaceFile(const std::filesystem::path& file);

}  // namespace falciform
