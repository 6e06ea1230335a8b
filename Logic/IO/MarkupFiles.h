#pragma once
#include <filesystem>

#include "Logic/Core/Landmarks.h"
#include "Logic/IO/Loaded.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// Reads 3D Slicer markups: `.mrk.json` (schema 1.0.3; LPS unless it says RAS) or `.fcsv` (RAS or LPS by its
/// header). Undefined points are left out with a warning. Throws InputError for damaged files.
[[nodiscard]] Loaded<Landmarks> readLandmarks(const std::filesystem::path& file);
/// Writes `.mrk.json`, coordinateSystem LPS.
void writeLandmarks(const std::filesystem::path& file, const Landmarks& landmarks, Overwrite overwrite);

}  // namespace falciform
