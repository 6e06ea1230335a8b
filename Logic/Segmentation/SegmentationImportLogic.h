#pragma once
#include <functional>

#include "Logic/Core/Case.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {

/// The import step on a Case, in the shape of RegistrationLogic.
class SegmentationImportLogic {
 public:
  explicit SegmentationImportLogic(Case& document) : case_(document) {}

  SurfaceImportSettings settings;

  [[nodiscard]] std::string missingInput() const;
  [[nodiscard]] std::function<SurfaceImportResult(const Progress&)> prepare() const;
  void accept(SurfaceImportResult result);
  const Surface& run(const Progress& progress = {});
  /// Of the import last accepted.
  [[nodiscard]] const SurfaceImportResult& last() const { return last_; }

 private:
  Case& case_;
  SurfaceImportResult last_;
};

}  // namespace falciform
