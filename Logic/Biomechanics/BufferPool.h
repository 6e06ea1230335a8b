#pragma once
#include <algorithm>
#include <cstddef>
#include <mutex>
#include <vector>

#include "Logic/Biomechanics/LargeMemory.h"

namespace falciform {

/// Hands out arrays of numbers and takes them back for others: memory fresh from the system costs as much as
/// the arithmetic on it. Any thread may ask. What an array holds is left over from its last user.
class BufferPool {
 public:
  struct Buffer {
    LargeArray<double> data;
    std::size_t capacity = 0;
  };

  [[nodiscard]] Buffer take(std::size_t count) {
    {
      const std::lock_guard lock(guard_);
      // The smallest that is large enough, and not so large that it is missed elsewhere.
      const auto fits =
          std::lower_bound(free_.begin(), free_.end(), count,
                           [](const Buffer& b, std::size_t wanted) { return b.capacity < wanted; });
      if (fits != free_.end() && fits->capacity <= 2 * count + kSmall) {
        Buffer found = std::move(*fits);
        free_.erase(fits);
        return found;
      }
    }
    return {largeArray<double>(count), count};
  }

  void giveBack(Buffer buffer) {
    if (!buffer.data) return;
    const std::lock_guard lock(guard_);
    const auto at =
        std::lower_bound(free_.begin(), free_.end(), buffer.capacity,
                         [](const Buffer& b, std::size_t capacity) { return b.capacity < capacity; });
    free_.insert(at, std::move(buffer));
  }

 private:
  static constexpr std::size_t kSmall = 4096;
  std::mutex guard_;
  std::vector<Buffer> free_;  ///< by capacity
};

}  // namespace falciform
