#pragma once
#include <memory>
#include <mutex>

#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// Keeps the last pre-operative surface made ready, so that the next job on the same one need not do it
/// again. Any thread.
class PreparedOnce {
 public:
  [[nodiscard]] std::shared_ptr<const PreparedPreop> of(const std::shared_ptr<const Surface>& preop) {
    const std::lock_guard lock(mutex_);
    if (preop != surface_ || !prepared_) {
      prepared_ = std::make_shared<const PreparedPreop>(*preop);
      surface_ = preop;
    }
    return prepared_;
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<const PreparedPreop> prepared_;
};

}  // namespace falciform
