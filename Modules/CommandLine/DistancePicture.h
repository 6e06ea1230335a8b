#pragma once
#include <filesystem>

#include "Logic/Core/Results.h"
#include "Logic/IO/OutputFile.h"

namespace falciform::commandline {

/// The pre-op surface seen from the scan's side, as .png: signed distance and, where they are there,
/// curvature difference and Couinaud segments.
void saveDistanceSheet(const DistanceMap& map, const Isometry3d& scanFromPreop,
                       const std::filesystem::path& file, Overwrite overwrite);

}  // namespace falciform::commandline
