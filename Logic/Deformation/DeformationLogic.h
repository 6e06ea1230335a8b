#pragma once
#include <functional>

#include "Logic/Core/Case.h"
#include "Logic/Deformation/DistanceMapping.h"

namespace falciform {

/// The distance map step on a Case, in the shape of RegistrationLogic.
class DeformationLogic {
 public:
  explicit DeformationLogic(Case& document) : case_(document) {}

  DistanceSettings settings;

  [[nodiscard]] std::string missingInput() const;
  [[nodiscard]] std::function<DistanceMap(const Progress&)> prepare() const;
  void accept(DistanceMap map);
  const DistanceMap& run(const Progress& progress = {});

 private:
  Case& case_;
};

}  // namespace falciform
