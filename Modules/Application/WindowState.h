#pragma once
#include <QString>
#include <functional>
#include <nlohmann/json.hpp>

#include "Modules/Workbench.h"

namespace falciform {

class CaseView3D;

/// How the window shows a case, as it is saved with it: looks, locks, the step, the camera.
[[nodiscard]] nlohmann::json lookOfWindow(const Workbench& bench, const CaseView3D& view,
                                          const QString& module);
/// The reverse; what is missing or makes no sense stays as it is.
void restoreWindow(const nlohmann::json& state, Workbench& bench, CaseView3D& view,
                   const std::function<void(const QString&)>& showModule);

}  // namespace falciform
