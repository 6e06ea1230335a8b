#pragma once
#include "Logic/Acquisition/SyntheticLiver.h"

namespace falciform::test {

/// A liver with edges of 5 mm, made once: enough shape for most claims in a tenth of the time.
inline const SyntheticLiver& coarseLiver() {
  static const SyntheticLiver liver = [] {
    SyntheticLiverSettings settings;
    settings.edgeLengthMm = 5;
    return makeSyntheticLiver(settings);
  }();
  return liver;
}

/// The default liver, made once.
inline const SyntheticLiver& defaultLiver() {
  static const SyntheticLiver liver = makeSyntheticLiver({});
  return liver;
}

}  // namespace falciform::test
