#include "Logic/Core/ParallelJobs.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

#include "Logic/Core/Parallel.h"

namespace falciform {

void forEachJob(std::size_t count, int atOnce, const std::function<void(std::size_t)>& job) {
  const int most = atOnce <= 0 ? threads() : std::min(atOnce, threads());
  const std::size_t lanes = std::min(count, static_cast<std::size_t>(most));
  std::atomic<std::size_t> next = 0;
  const auto lane = [&] {
    for (std::size_t i; (i = next++) < count;) {
      try {
        tbb::this_task_arena::isolate([&] { job(i); });
      } catch (...) {
        next = count;  // the other lanes begin nothing more
        throw;
      }
    }
  };
  if (lanes <= 1) return lane();
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, lanes, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t c = range.begin(); c != range.end(); ++c) lane();
      },
      tbb::simple_partitioner());
}

}  // namespace falciform
