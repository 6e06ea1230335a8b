#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "Logic/Core/KeptUpdate.h"

namespace falciform {

/// Figures and targets of a kept update, units in the keys; not its surfaces. NaN becomes null.
[[nodiscard]] nlohmann::json toJson(const KeptUpdate& update);
/// The reverse; throws InputError naming the key for anything missing or wrong.
[[nodiscard]] KeptUpdate keptUpdateFromJson(const nlohmann::json& json);

}  // namespace falciform
