#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Widgets/Rendering/Picking.h"
#include "Widgets/Views/CaseScene.h"

namespace falciform {

/// Says in words what lies under the mouse: part, vertex, patch, position, signed distance. Keeps a search
/// tree a shape.
class DataProbe {
 public:
  /// At pixel (x, y), origin bottom left; empty where there is nothing.
  [[nodiscard]] std::string at(CaseScene& scene, double x, double y);

 private:
  const SurfacePicker& pickerFor(const ShownSurface& shown);

  std::map<std::string, std::unique_ptr<SurfacePicker>> pickers_;
};

}  // namespace falciform
