#pragma once
#include <functional>
#include <vector>

class QWidget;

namespace falciform {

class ModulePanel;
struct Workbench;

/// One module of the window.
struct Module {
  const char* key;      ///< objectName of its panel and name of its folder
  const char* title;    ///< as in the selector
  const char* chapter;  ///< of the thesis
  std::function<ModulePanel*(Workbench&, QWidget* parent)> makePanel;
};

/// All modules, in the order of the work. A new module is a folder and a line here.
[[nodiscard]] const std::vector<Module>& moduleList();

}  // namespace falciform
