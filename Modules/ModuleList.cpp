#include "Modules/ModuleList.h"

#include "Modules/AtlasUpdate/AtlasUpdatePanel.h"
#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"
#include "Modules/PatchPainting/PatchPaintingPanel.h"
#include "Modules/Registration/RegistrationPanel.h"
#include "Modules/SegmentationImport/SegmentationImportPanel.h"

namespace falciform {
namespace {

template <class Panel>
Module module(const char* key, const char* title, const char* chapter) {
  return {key, title, chapter, [key](Workbench& bench, QWidget* parent) -> ModulePanel* {
            auto* panel = new Panel(bench, parent);
            panel->setObjectName(key);
            return panel;
          }};
}

}  // namespace

const std::vector<Module>& moduleList() {
  static const std::vector<Module> modules{
      module<SegmentationImportPanel>("SegmentationImport", "1. Segmentation import", "II"),
      module<PatchPaintingPanel>("PatchPainting", "2. Patch painting", "III"),
      module<RegistrationPanel>("Registration", "3. Registration", "III"),
      module<DeformationAnalysisPanel>("DeformationAnalysis", "4. Deformation analysis", "IV"),
      module<AtlasUpdatePanel>("AtlasUpdate", "5. Atlas update", "V"),
  };
  return modules;
}

}  // namespace falciform
