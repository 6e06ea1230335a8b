#include "Widgets/Jobs/LatestRunner.h"

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <exception>

#include "Logic/Core/Errors.h"

namespace falciform {

struct LatestRunner::Running : QObject {
  using QObject::QObject;
  Job job;
  bool dropped = false;
  QFutureWatcher<void> watcher;
  std::exception_ptr error;  // written by the worker before the watcher reports the end
};

LatestRunner::LatestRunner(JobRunner::Mode mode, QObject* parent) : QObject(parent), mode_(mode) {}

LatestRunner::~LatestRunner() {
  drop();
  if (!running_) return;
  running_->watcher.disconnect();
  running_->watcher.waitForFinished();
}

void LatestRunner::drop() {
  waiting_.reset();
  if (running_) running_->dropped = true;
}

void LatestRunner::take(Job job) {
  if (running_)
    waiting_ = std::move(job);
  else
    start(std::move(job));
}

void LatestRunner::start(Job job) {
  running_ = new Running(this);
  running_->job = std::move(job);
  auto body = [running = running_] {
    try {
      running->job.work();
    } catch (...) {
      running->error = std::current_exception();
    }
  };
  if (mode_ == JobRunner::Mode::Inline) {
    body();
    settle();
    return;
  }
  connect(&running_->watcher, &QFutureWatcher<void>::finished, this, &LatestRunner::settle);
  running_->watcher.setFuture(QtConcurrent::run(std::move(body)));
}

void LatestRunner::settle() {
  const auto job = std::move(running_->job);
  const std::exception_ptr error = running_->error;
  const bool dropped = running_->dropped;
  running_->deleteLater();
  running_ = nullptr;
  // First, so that the worker is at it while the result is drawn.
  if (waiting_) start(*std::exchange(waiting_, std::nullopt));
  if (dropped) return;
  try {
    if (error) std::rethrow_exception(error);
    job.done();
  } catch (const std::bad_alloc&) {
    Q_EMIT failed(tr("Not enough memory."));
  } catch (const InputError& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Internal error: %1").arg(QString::fromUtf8(e.what())));
  }
}

}  // namespace falciform
