#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Patches/PatchStatistics.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform::commandline {

/// `value` with `decimals` places in the C locale; "-" for NaN.
[[nodiscard]] std::string fixed(double value, int decimals);

/// Volumes, voxels, topology; not the surface.
[[nodiscard]] nlohmann::json toJson(const SurfaceImportResult& result);
/// Counts, shapes, distances and regions; not the mesh.
[[nodiscard]] nlohmann::json toJson(const MeshReport& report);
/// One object a patch.
[[nodiscard]] nlohmann::json toJson(const std::vector<PatchStatistics>& patches);

}  // namespace falciform::commandline
