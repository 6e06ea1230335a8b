#pragma once
#include <mutex>
#include <vector>

namespace falciform {

/// What a running job tells of its iterations: the job's thread writes, the panel looks a few times a second.
/// Shared by two threads while it changes, hence the lock. A record numbered 1 begins a
/// new start and forgets the last one.
template <class Record>
class LiveRecords {
 public:
  void add(const Record& record) {
    const std::lock_guard lock(mutex_);
    if (record.iteration == 1) records_.clear();
    records_.push_back(record);
  }
  [[nodiscard]] std::vector<Record> records() const {
    const std::lock_guard lock(mutex_);
    return records_;
  }
  [[nodiscard]] std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return records_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Record> records_;
};

}  // namespace falciform
