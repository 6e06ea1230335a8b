#pragma once
#include <string>

#include "Logic/Patches/FeatureModel.h"

namespace falciform::bench {

/// The model as Logic/Patches/FeatureModelWeights.cpp holds it.
[[nodiscard]] std::string modelAsSource(const FeatureModel& model);

}  // namespace falciform::bench
