#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

/// `name = value` lines, one for each declared field that the figures hold (3D Slicer's
/// --returnparameterfile).
[[nodiscard]] std::string returnParameters(const std::vector<ResultField>& fields,
                                           const nlohmann::json& figures);

}  // namespace falciform::commandline
