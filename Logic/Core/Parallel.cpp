#include "Logic/Core/Parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <thread>

namespace falciform {

namespace {

std::mutex guard;
std::unique_ptr<tbb::global_control> limit;
int chosen = 0;

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace

void setThreads(int count) {
  const std::lock_guard lock(guard);
  chosen = std::max(0, count);
  const auto allowed = static_cast<std::size_t>(chosen == 0 ? cores() : chosen);
  limit.reset();
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, allowed);
}

int threads() {
  const std::lock_guard lock(guard);
  return chosen == 0 ? cores() : chosen;
}

void forEachChunk(std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  chunk = std::max<std::size_t>(chunk, 1);
  const std::size_t chunks = (count + chunk - 1) / chunk;
  const auto one = [&](std::size_t c) { body(c * chunk, std::min(count, (c + 1) * chunk)); };
  if (chunks <= 1 || threads() == 1) {
    for (std::size_t c = 0; c < chunks; ++c) one(c);
    return;
  }
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, chunks, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c) one(c);
      },
      tbb::simple_partitioner());
}

}  // namespace falciform
