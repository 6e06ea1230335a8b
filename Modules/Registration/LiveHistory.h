#pragma once
#include <memory>
#include <mutex>
#include <vector>

#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform {

/// Iterations of the running registration: the job's thread writes, the panel looks a few times a second. The
/// one place where two threads share something that changes, hence the lock.
class LiveHistory {
 public:
  /// To be handed to the job. A record numbered 1 begins a new start and forgets the last one.
  [[nodiscard]] static IterationObserver observerOf(const std::shared_ptr<LiveHistory>& history) {
    return [history](const IterationRecord& record) { history->add(record); };
  }

  [[nodiscard]] std::vector<IterationRecord> records() const {
    const std::lock_guard lock(mutex_);
    return records_;
  }
  [[nodiscard]] std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return records_.size();
  }

 private:
  void add(const IterationRecord& record) {
    const std::lock_guard lock(mutex_);
    if (record.iteration == 1) records_.clear();
    records_.push_back(record);
  }

  mutable std::mutex mutex_;
  std::vector<IterationRecord> records_;
};

/// What is known of a registration that the user stopped: the pose and residual of its last iteration. All
/// other figures are NaN.
[[nodiscard]] RegistrationResult stoppedResult(const std::vector<IterationRecord>& records, Index scanPoints,
                                               Index preopPoints);

}  // namespace falciform
