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
  /// Couinaud segments, labels 1 to 8, of the CT that the surface was made of: for figures by segment.
  /// Without it, an array `couinaud_segment` of the surface is taken if there is one.
  std::shared_ptr<const LabelMap> segments;

  [[nodiscard]] std::string missingInput() const;
  [[nodiscard]] std::function<DistanceMap(const Progress&)> prepare() const;
  void accept(DistanceMap map);
  const DistanceMap& run(const Progress& progress = {});

 private:
  Case& case_;
};

}  // namespace falciform
