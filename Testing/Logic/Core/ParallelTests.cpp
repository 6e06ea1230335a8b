#include "Logic/Core/Parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace falciform {

namespace {

/// Puts the number of threads back at the end of a test.
class Parallel : public ::testing::Test {
 protected:
  ~Parallel() override { setThreads(0); }
};

/// A sum whose rounding depends on how it is cut: the same only if the cut is the same.
double sumByChunks(std::size_t count, std::size_t chunk) {
  std::vector<double> parts((count + chunk - 1) / chunk);
  forEachChunk(count, chunk, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += std::sin(static_cast<double>(i)) * 1e-3 + 1.0 / (1.0 + static_cast<double>(i));
    parts[begin / chunk] = sum;
  });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

}  // namespace

TEST_F(Parallel, EveryItemIsVisitedOnceInChunksOfTheAskedSize) {
  for (const int count : {1, 2, 3, 8})
    for (const std::size_t items : {0U, 1U, 7U, 64U, 1000U, 1001U})
      for (const std::size_t chunk : {1U, 7U, 64U, 5000U}) {
        setThreads(count);
        std::vector<std::atomic<int>> visits(items);
        forEachChunk(items, chunk, [&](std::size_t begin, std::size_t end) {
          EXPECT_LT(begin, end);
          EXPECT_EQ(begin % chunk, 0U);
          EXPECT_EQ(end, std::min(items, begin + chunk));
          for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        for (std::size_t i = 0; i < items; ++i)
          ASSERT_EQ(visits[i], 1) << i << " of " << items << " in chunks of " << chunk;
      }
}

TEST_F(Parallel, ResultsDoNotDependOnTheNumberOfThreads) {
  setThreads(1);
  const double expected = sumByChunks(100003, 97);
  for (const int count : {2, 3, 4, 16}) {
    setThreads(count);
    for (int again = 0; again < 5; ++again)
      EXPECT_EQ(sumByChunks(100003, 97), expected) << count << " threads, to the last bit";
  }
}

TEST_F(Parallel, AnExceptionOfABodyIsRethrownToTheCaller) {
  for (const int count : {1, 4}) {
    setThreads(count);
    const auto work = [] {
      forEachChunk(1000, 10, [](std::size_t begin, std::size_t) {
        if (begin == 500) throw std::runtime_error("chunk 50");
      });
    };
    try {
      work();
      ADD_FAILURE() << "nothing was thrown with " << count << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "chunk 50");
    }
    EXPECT_NO_THROW(forEachChunk(100, 10, [](std::size_t, std::size_t) {})) << "and the next call works";
  }
}

TEST_F(Parallel, CallsMayNest) {
  setThreads(4);
  std::atomic<int> visits = 0;
  forEachChunk(20, 1, [&](std::size_t, std::size_t) {
    forEachChunk(30, 4, [&](std::size_t b, std::size_t e) { visits += static_cast<int>(e - b); });
  });
  EXPECT_EQ(visits, 600);
}

TEST_F(Parallel, ThreadsAreAsSetAndZeroMeansAllCores) {
  setThreads(3);
  EXPECT_EQ(threads(), 3);
  setThreads(0);
  EXPECT_GE(threads(), 1);
  setThreads(-5);
  EXPECT_GE(threads(), 1);
}

TEST_F(Parallel, AChunkOfZeroItemsCountsAsOne) {
  std::atomic<int> visits = 0;
  forEachChunk(5, 0, [&](std::size_t begin, std::size_t end) { visits += static_cast<int>(end - begin); });
  EXPECT_EQ(visits, 5);
}

}  // namespace falciform
