#pragma once
#include <memory>
#include <vector>

#include "Logic/Registration/SurfaceRegistration.h"
#include "Widgets/Jobs/LiveRecords.h"

namespace falciform {

/// Iterations of the running registration.
class LiveHistory : public LiveRecords<IterationRecord> {
 public:
  /// To be handed to the job.
  [[nodiscard]] static IterationObserver observerOf(const std::shared_ptr<LiveHistory>& history) {
    return [history](const IterationRecord& record) { history->add(record); };
  }
};

/// What is known of a registration that the user stopped: the pose and residual of its last iteration. All
/// other figures are NaN.
[[nodiscard]] RegistrationResult stoppedResult(const std::vector<IterationRecord>& records, Index scanPoints,
                                               Index preopPoints);

}  // namespace falciform
