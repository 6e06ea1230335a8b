#include "Logic/Segmentation/SegmentationImportLogic.h"

#include <memory>
#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/Segmentation/StructureImport.h"

namespace falciform {

std::string SegmentationImportLogic::missingInput() const {
  if (!case_.labels()) return "Load a label map first.";
  if (case_.labels()->voxels.empty()) return "The label map has no voxels; load another.";
  return {};
}

std::function<SurfaceImportResult(const Progress&)> SegmentationImportLogic::prepare() const {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  return [labels = case_.labels(), snapshot = settings](const Progress& progress) {
    return importSurface(*labels, snapshot, progress);
  };
}

void SegmentationImportLogic::accept(SurfaceImportResult result) {
  last_ = std::move(result);
  case_.setPreop(std::make_shared<Surface>(last_.surface));
}

std::function<std::map<std::string, Surface>(const Progress&)> SegmentationImportLogic::prepareStructures()
    const {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  return [labels = case_.labels(), wanted = structures](const Progress& progress) {
    std::map<std::string, Surface> surfaces;
    for (const auto& [label, name] : wanted) {
      progress.report(static_cast<double>(surfaces.size()) / static_cast<double>(wanted.size()),
                      "Vessels and tumours");
      surfaces[name] = structureSurface(*labels, label);
    }
    return surfaces;
  };
}

void SegmentationImportLogic::acceptStructures(std::map<std::string, Surface> surfaces) {
  for (auto& [name, surface] : surfaces)
    case_.setStructure(name, std::make_shared<const Surface>(std::move(surface)));
}

const Surface& SegmentationImportLogic::run(const Progress& progress) {
  accept(prepare()(progress));
  return *case_.preop();
}

}  // namespace falciform
