#include "Logic/Core/ParallelJobs.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

class ParallelJobs : public ::testing::Test {
 protected:
  ~ParallelJobs() override { setThreads(0); }
};

}  // namespace

TEST_F(ParallelJobs, EveryJobRunsOnceWhateverTheThreads) {
  for (const int threadCount : {1, 2, 5})
    for (const int atOnce : {0, 1, 3, 9})
      for (const std::size_t count : {0U, 1U, 2U, 100U}) {
        setThreads(threadCount);
        std::vector<std::atomic<int>> runs(count);
        forEachJob(count, atOnce, [&](std::size_t i) { ++runs[i]; });
        for (const auto& ran : runs) ASSERT_EQ(ran, 1);
      }
}

TEST_F(ParallelJobs, NoMoreRunAtATimeThanAskedForAndOneAtATimeIsInOrder) {
  setThreads(4);
  for (const int atOnce : {1, 2, 3}) {
    std::atomic<int> running = 0, most = 0;
    std::vector<std::size_t> order;
    forEachJob(24, atOnce, [&](std::size_t i) {
      const int now = ++running;
      for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
      }
      if (atOnce == 1) order.push_back(i);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --running;
    });
    EXPECT_LE(most, atOnce);
    for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
  }
}

TEST_F(ParallelJobs, AThreadThatWaitsInsideAJobTakesUpNoOther) {
  setThreads(4);
  static thread_local bool inside = false;
  std::atomic<int> nested = 0;
  // More lanes than cores, threads that run out of jobs and help with inner chunks of uneven length: without
  // isolation a wait picks up another lane in many of the rounds.
  tbb::task_arena four(4);
  for (int round = 0; round < 100; ++round)
    four.execute([&] {
      forEachJob(9, 0, [&](std::size_t) {
        if (inside) ++nested;
        inside = true;
        forEachChunk(8, 1, [&](std::size_t begin, std::size_t) {
          std::this_thread::sleep_for(std::chrono::microseconds(begin % 2 == 0 ? 20 : 120));
        });
        inside = false;
      });
    });
  EXPECT_EQ(nested, 0);
}

TEST_F(ParallelJobs, AnExceptionArrivesAndNoFurtherJobBegins) {
  for (const int threadCount : {1, 3}) {
    setThreads(threadCount);
    std::atomic<int> begun = 0;
    EXPECT_THROW(forEachJob(10000, 0,
                            [&](std::size_t i) {
                              ++begun;
                              if (i == 5) throw std::runtime_error("job 5");
                              std::this_thread::sleep_for(std::chrono::microseconds(200));
                            }),
                 std::runtime_error);
    // Jobs 0 to 5, and what the other lanes had begun before they saw it: a few, never thousands.
    EXPECT_LT(begun, 1000);
  }
}

}  // namespace falciform
