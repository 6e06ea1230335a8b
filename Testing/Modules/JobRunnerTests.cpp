#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <thread>

#include "Logic/Core/Errors.h"
#include "Widgets/Jobs/JobRunner.h"

namespace falciform {
namespace {

using namespace std::chrono_literals;

/// Runs the event loop until `signal` comes, 10 s at most: a job that never ends fails the test instead of
/// hanging it.
template <class Signal>
void waitFor(JobRunner& runner, Signal signal) {
  QEventLoop loop;
  QTimer::singleShot(10000, &loop, [&] {
    ADD_FAILURE() << "waited 10 s in vain";
    loop.quit();
  });
  QObject::connect(&runner, signal, &loop, &QEventLoop::quit, Qt::QueuedConnection);
  loop.exec();
}

/// Reports until it is stopped.
int endless(const Progress& progress) {
  for (;;) {
    progress.report(0.5, "working");
    std::this_thread::sleep_for(1ms);
  }
}

TEST(JobRunner, InlineModeHasTheResultWhenStartReturns) {
  JobRunner runner(JobRunner::Mode::Inline);
  int got = 0;
  EXPECT_TRUE(runner.start(
      "Job", [](const Progress&) { return 42; }, [&](int result) { got = result; }));
  EXPECT_EQ(got, 42);
  EXPECT_FALSE(runner.busy());
}

TEST(JobRunner, WorksOnAnotherThreadAndDeliversOnTheOwners) {
  JobRunner runner;
  QThread *worker = nullptr, *deliverer = nullptr;
  runner.start(
      "Job", [](const Progress&) { return QThread::currentThread(); },
      [&](QThread* thread) {
        worker = thread;
        deliverer = QThread::currentThread();
      });
  EXPECT_TRUE(runner.busy());
  waitFor(runner, &JobRunner::finished);
  EXPECT_NE(worker, QThread::currentThread());
  EXPECT_EQ(deliverer, QThread::currentThread());
}

TEST(JobRunner, RefusesASecondJobWhileOneRuns) {
  JobRunner runner;
  bool secondRan = false;
  ASSERT_TRUE(runner.start("First", endless, [](int) {}));
  EXPECT_FALSE(runner.start(
      "Second", [](const Progress&) { return 1; }, [&](int) { secondRan = true; }));
  EXPECT_EQ(runner.title(), "First");
  runner.cancel();
  waitFor(runner, &JobRunner::finished);
  EXPECT_FALSE(secondRan);
}

TEST(JobRunner, CancelCallsStoppedAndNotDone) {
  JobRunner runner;
  bool done = false, stopped = false, failed = false;
  QObject::connect(&runner, &JobRunner::failed, [&] { failed = true; });
  runner.start(
      "Job", endless, [&](int) { done = true; }, [&] { stopped = true; });
  QTimer::singleShot(20, [&] { runner.cancel(); });
  waitFor(runner, &JobRunner::finished);
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(done);
  EXPECT_FALSE(failed) << "cancelling is no error";
}

TEST(JobRunner, AnInputErrorIsToldInItsOwnWords) {
  JobRunner runner;
  QString message;
  QObject::connect(&runner, &JobRunner::failed, [&](const QString& text) { message = text; });
  runner.start(
      "Job", [](const Progress&) -> int { throw InputError("label 7 is not there; choose 1 or 2"); },
      [](int) {});
  waitFor(runner, &JobRunner::finished);
  EXPECT_EQ(message, "label 7 is not there; choose 1 or 2");
  EXPECT_FALSE(runner.busy());
}

TEST(JobRunner, AnErrorWhileTheResultIsAcceptedIsToldToo) {
  JobRunner runner(JobRunner::Mode::Inline);
  QString message;
  QObject::connect(&runner, &JobRunner::failed, [&](const QString& text) { message = text; });
  runner.start(
      "Job", [](const Progress&) { return 1; }, [](int) { throw InputError("no room"); });
  EXPECT_EQ(message, "no room");
}

TEST(JobRunner, ProgressArrivesOnTheOwnersThreadWithItsStages) {
  JobRunner runner;
  QStringList stages;
  double last = 0;
  bool ownThread = true;
  QObject::connect(&runner, &JobRunner::progressed, &runner, [&](double fraction, const QString& stage) {
    ownThread = ownThread && QThread::currentThread() == runner.thread();
    last = fraction;
    if (!stage.isEmpty()) stages << stage;
  });
  runner.start(
      "Job",
      [](const Progress& progress) {
        progress.report(0.25, "one");
        progress.report(0.75, "two");
        return 0;
      },
      [](int) {});
  waitFor(runner, &JobRunner::finished);
  EXPECT_TRUE(ownThread);
  EXPECT_EQ(stages, QStringList({"one", "two"}));
  EXPECT_DOUBLE_EQ(last, 0.75);
}

TEST(JobRunner, AThousandReportsAMillisecondDoNotFloodTheEventLoop) {
  JobRunner runner;
  int arrived = 0, reports = 0;
  std::chrono::duration<double, std::milli> took{};
  QObject::connect(&runner, &JobRunner::progressed, [&] { ++arrived; });
  runner.start(
      "Job",
      [&](const Progress& progress) {
        const auto began = std::chrono::steady_clock::now();
        for (; took < 200ms; took = std::chrono::steady_clock::now() - began, ++reports) progress.report(0.5);
        return 0;
      },
      [](int) {});
  waitFor(runner, &JobRunner::finished);
  EXPECT_GT(reports, 1000);
  EXPECT_LE(arrived, took.count() / 33 + 2);  // one a 33 ms, the first, and rounding
}

TEST(JobRunner, DestroyingItDuringAJobStopsTheJobAndDropsTheResult) {
  std::atomic<bool> ended = false;
  bool called = false;
  {
    JobRunner runner;
    runner.start(
        "Job",
        [&](const Progress& progress) {
          try {
            return endless(progress);
          } catch (const Cancelled&) {
            ended = true;
            throw;
          }
        },
        [&](int) { called = true; }, [&] { called = true; });
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_TRUE(ended) << "the runner waited for its job";
  QCoreApplication::processEvents();
  EXPECT_FALSE(called);
}

TEST(JobRunner, DoneMayStartTheNextJob) {
  JobRunner runner;
  int second = 0;
  runner.start(
      "First", [](const Progress&) { return 20; },
      [&](int first) {
        runner.start(
            "Second", [first](const Progress&) { return first + 1; }, [&](int result) { second = result; });
      });
  waitFor(runner, &JobRunner::finished);
  if (runner.busy()) waitFor(runner, &JobRunner::finished);
  EXPECT_EQ(second, 21);
}

}  // namespace
}  // namespace falciform
