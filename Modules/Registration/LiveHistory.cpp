#include "Modules/Registration/LiveHistory.h"

#include <cmath>
#include <limits>

namespace falciform {

RegistrationResult stoppedResult(const std::vector<IterationRecord>& records, Index scanPoints,
                                 Index preopPoints) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  RegistrationResult result;
  result.scanFromPreop = records.back().preopFromScan.inverse();
  result.rmsMm = records.back().rmsMm;
  result.weightedRmsMm = result.meanMm = result.p95Mm = result.coverage = kUnknown;
  result.rotationDeg = result.translationMm = kUnknown;
  result.iterations = static_cast<int>(records.size());
  result.converged = false;
  result.stopReason = "stopped by the user";
  result.history = records;
  result.warnings = {"Stopped before the end: this is the pose of the last iteration, not a minimum."};
  result.scanPoints = scanPoints;
  result.preopPoints = preopPoints;
  return result;
}

}  // namespace falciform
