#pragma once
#include <memory>
#include <mutex>

namespace falciform {

/// The newest of what a running job has to show: the job's thread sets it, the panel looks a few times a
/// second. As LiveRecords, it is shared by two threads, hence the lock.
template <class T>
class LiveValue {
 public:
  void set(std::shared_ptr<const T> value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  /// nullptr until the first is set.
  [[nodiscard]] std::shared_ptr<const T> get() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace falciform
