#include "Modules/Application/WindowState.h"

#include "Widgets/Views/CaseView3D.h"
#include "Widgets/Views/ViewFile.h"

namespace falciform {

nlohmann::json lookOfWindow(const Workbench& bench, const CaseView3D& view, const QString& module) {
  nlohmann::json state = toJson(bench.view.options());
  state["locked_patches"] = bench.painting.locked();
  state["module"] = module.toStdString();
  state["camera"] = view.camera();
  return state;
}

void restoreWindow(const nlohmann::json& state, Workbench& bench, CaseView3D& view,
                   const std::function<void(const QString&)>& showModule) {
  bench.view.edit([&](ViewOptions& options) { readView(state, options); });
  for (const int label : std::set<int>(bench.painting.locked())) bench.painting.setLocked(label, false);
  if (const auto locked = state.find("locked_patches"); locked != state.end() && locked->is_array())
    for (const nlohmann::json& label : *locked)
      if (label.is_number_integer() && label >= 1 && label <= patch::kMax)
        bench.painting.setLocked(label.get<int>(), true);
  if (const auto module = state.find("module"); module != state.end() && module->is_string())
    showModule(QString::fromStdString(module->get<std::string>()));
  std::vector<double> camera;
  if (const auto saved = state.find("camera"); saved != state.end() && saved->is_array())
    for (const nlohmann::json& value : *saved)
      if (value.is_number()) camera.push_back(value.get<double>());
  view.setCamera(camera);
  bench.view.brushChanged.emit();
}

}  // namespace falciform
