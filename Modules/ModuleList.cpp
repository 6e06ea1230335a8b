#include "Modules/ModuleList.h"

#include "Modules/AtlasUpdate/AtlasUpdatePanel.h"
#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"
#include "Modules/PatchPainting/PatchPaintingPanel.h"
#include "Modules/Registration/RegistrationPanel.h"
#include "Modules/ScanPreparation/ScanPreparationPanel.h"
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
      module<ScanPreparationPanel>("ScanPreparation", "2. Scan preparation", "II"),
      module<PatchPaintingPanel>("PatchPainting", "3. Patch painting", "III"),
      module<RegistrationPanel>("Registration", "4. Registration", "III"),
      module<DeformationAnalysisPanel>("DeformationAnalysis", "5. Deformation analysis", "IV"),
      module<AtlasUpdatePanel>("AtlasUpdate", "6. Atlas update", "V"),
  };
  return modules;
}

}  // namespace falciform
