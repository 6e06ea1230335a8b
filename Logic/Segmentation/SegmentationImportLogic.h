#pragma once
#include <functional>
#include <map>
#include <string>

#include "Logic/Core/Case.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {

/// The import step on a Case, in the shape of RegistrationLogic.
class SegmentationImportLogic {
 public:
  explicit SegmentationImportLogic(Case& document) : case_(document) {}

  SurfaceImportSettings settings;
  std::map<int, std::string> structures;  ///< labels that also come in as vessels and tumours, by name

  [[nodiscard]] std::string missingInput() const;
  [[nodiscard]] std::function<SurfaceImportResult(const Progress&)> prepare() const;
  void accept(SurfaceImportResult result);
  /// Surfaces of `structures`, by name. Throws InputError where a label is not in the map.
  [[nodiscard]] std::function<std::map<std::string, Surface>(const Progress&)> prepareStructures() const;
  void acceptStructures(std::map<std::string, Surface> surfaces);
  const Surface& run(const Progress& progress = {});
  /// Of the import last accepted.
  [[nodiscard]] const SurfaceImportResult& last() const { return last_; }

 private:
  Case& case_;
  SurfaceImportResult last_;
};

}  // namespace falciform
