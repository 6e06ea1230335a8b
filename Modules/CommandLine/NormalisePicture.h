#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"
#include "Logic/IO/OutputFile.h"

namespace falciform::commandline {

/// As .png, from the front: the target, the source as it was, and the source brought onto the target,
/// coloured by its `distance_to_target_mm` (thesis Fig. IV.4).
void saveNormaliseSheet(const Surface& target, const Surface& source, const Surface& moved,
                        const std::filesystem::path& file, Overwrite overwrite);

}  // namespace falciform::commandline
