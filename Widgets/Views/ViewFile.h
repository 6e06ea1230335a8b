#pragma once
#include <nlohmann/json.hpp>

#include "Widgets/Views/ViewState.h"

namespace falciform {

/// How parts and patches look and what is shown beside them, as a saved case keeps it: not what a step shows
/// while it is on screen.
[[nodiscard]] nlohmann::json toJson(const ViewOptions& options);
/// The reverse, into `options`; what is missing or makes no sense stays as it is: a look is no reason to
/// refuse a case.
void readView(const nlohmann::json& json, ViewOptions& options);

}  // namespace falciform
