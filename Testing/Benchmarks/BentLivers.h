#pragma once
#include "Logic/Acquisition/SyntheticLiver.h"
#include "Testing/Benchmarks/AimedScan.h"
#include "Testing/Benchmarks/BenchCases.h"

namespace falciform::bench {

/// A liver whose shape and bending are drawn from a seed, and scans of it. All of one seed show the same
/// body.
class BentLiver {
 public:
  BentLiver(int seed, double bendingRmsMm, double edgeLengthMm);

  [[nodiscard]] const Surface& preop() const { return before_.surface; }
  /// Stations that see `visibleShare` of it (AimedScan.h), drawn anew until at least 30 points of each patch
  /// are in view, as a user would aim.
  [[nodiscard]] std::vector<Station> aim(double visibleShare) const;
  /// What is seen from there. Targets: those inside the liver. Success: 1.4 x optimal + 1 mm.
  [[nodiscard]] BenchCase seen(const std::vector<Station>& stations, double noiseMm, int stride = 3) const;

 private:
  int seed_;
  SyntheticLiver before_, after_;
};

}  // namespace falciform::bench
