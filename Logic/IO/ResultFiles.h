#pragma once
#include <nlohmann/json.hpp>

#include "Logic/Core/Results.h"

namespace falciform {

/// Units in the keys (`rms_mm`, `rotation_deg`); matrices row-major; history and basins included. NaN becomes
/// null.
[[nodiscard]] nlohmann::json toJson(const RegistrationResult& result);
/// The reverse; throws InputError naming the key for anything missing or wrong.
[[nodiscard]] RegistrationResult registrationFromJson(const nlohmann::json& json);
[[nodiscard]] nlohmann::json toJson(const DistanceStatistics& statistics);
/// "all", "patch" or "segment".
[[nodiscard]] std::string regionKindName(RegionFigures::Kind kind);
/// Statistics of the map, by side and by region; not the surfaces.
[[nodiscard]] nlohmann::json toJson(const DistanceMap& map);
/// The reverse, with the surfaces that were saved beside it.
[[nodiscard]] DistanceMap distanceFromJson(const nlohmann::json& json, Surface preop, Surface scan);
/// One row per side and region: "side,region,kind,area_mm2,covered_area_mm2,coverage,count,mean_mm,...", the
/// same of curvature differences after it; C locale. No value is an empty cell.
[[nodiscard]] std::string toCsv(const DistanceMap& map);

}  // namespace falciform
