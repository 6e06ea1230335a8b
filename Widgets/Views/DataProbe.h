#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Widgets/Rendering/Picking.h"
#include "Widgets/Views/CaseScene.h"

namespace falciform {

/// Says in words what lies under the mouse: part, value, patch, place. Keeps a search tree a shape.
class DataProbe {
 public:
  /// At pixel (x, y) of the renderer's window, origin bottom left; empty where there is nothing.
  [[nodiscard]] std::string at(vtkRenderer* renderer, const std::vector<ShownSurface>& shown, double x,
                               double y);

 private:
  const SurfacePicker& pickerFor(const ShownSurface& shown);

  std::map<std::string, std::unique_ptr<SurfacePicker>> pickers_;
};

}  // namespace falciform
