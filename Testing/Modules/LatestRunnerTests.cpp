#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Widgets/Jobs/LatestRunner.h"

namespace falciform {
namespace {

using namespace std::chrono_literals;

/// Runs the event loop until nothing is under way, 10 s at most.
void settle(LatestRunner& runner) {
  QElapsedTimer timer;
  timer.start();
  while (runner.busy() && timer.elapsed() < 10000) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  QCoreApplication::processEvents();
  EXPECT_FALSE(runner.busy()) << "waited 10 s in vain";
}

TEST(LatestRunner, OfManyOnlyTheFirstAndTheNewestAreWorkedOn) {
  LatestRunner runner;
  std::atomic<int> worked = 0;
  std::vector<int> shown;
  for (int i = 0; i < 100; ++i)
    runner.submit(
        [i, &worked] {
          ++worked;
          std::this_thread::sleep_for(5ms);
          return i;
        },
        [&](int value) { shown.push_back(value); });
  settle(runner);
  EXPECT_EQ(shown, (std::vector<int>{0, 99}));
  EXPECT_EQ(worked, 2);
}

TEST(LatestRunner, WorksOnAnotherThreadAndDeliversOnTheOwners) {
  LatestRunner runner;
  QThread *worker = nullptr, *deliverer = nullptr;
  runner.submit([] { return QThread::currentThread(); },
                [&](QThread* thread) {
                  worker = thread;
                  deliverer = QThread::currentThread();
                });
  settle(runner);
  EXPECT_NE(worker, QThread::currentThread());
  EXPECT_EQ(deliverer, QThread::currentThread());
}

TEST(LatestRunner, DroppedResultsAreNotShownAndLaterOnesAre) {
  LatestRunner runner;
  int shown = 0;
  runner.submit([] { return 1; }, [&](int value) { shown = value; });
  runner.drop();
  settle(runner);
  EXPECT_EQ(shown, 0);
  runner.submit([] { return 2; }, [&](int value) { shown = value; });
  settle(runner);
  EXPECT_EQ(shown, 2);
}

TEST(LatestRunner, AFaultIsToldAndEndsNothing) {
  LatestRunner runner(JobRunner::Mode::Inline);
  QString told;
  QObject::connect(&runner, &LatestRunner::failed, [&](const QString& message) { told = message; });
  runner.submit([]() -> int { throw InputError("nothing holds the liver"); }, [](int) { FAIL(); });
  EXPECT_EQ(told, "nothing holds the liver");
  int shown = 0;
  runner.submit([] { return 3; }, [&](int value) { shown = value; });
  EXPECT_EQ(shown, 3);
}

TEST(LatestRunner, DestroyingItWaitsForTheWorkAndDropsItsResult) {
  std::atomic<bool> ended = false;
  bool shown = false;
  {
    LatestRunner runner;
    runner.submit(
        [&] {
          std::this_thread::sleep_for(20ms);
          ended = true;
          return 0;
        },
        [&](int) { shown = true; });
  }
  EXPECT_TRUE(ended);
  QCoreApplication::processEvents();
  EXPECT_FALSE(shown);
}

}  // namespace
}  // namespace falciform
