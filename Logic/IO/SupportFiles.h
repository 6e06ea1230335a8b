#pragma once
#include <nlohmann/json.hpp>

#include "Logic/Core/SupportPainting.h"

namespace falciform {

/// Regions by label with name, kind and push_mm; turn_deg; the points' labels as runs [label, count, ...] in
/// the order of the pre-operative surface's points.
[[nodiscard]] nlohmann::json toJson(const SupportPainting& painting);

/// The reverse, for a surface of `points` points; throws InputError naming the key for anything missing or
/// wrong.
[[nodiscard]] SupportPainting supportPaintingFromJson(const nlohmann::json& json, Index points);

}  // namespace falciform
