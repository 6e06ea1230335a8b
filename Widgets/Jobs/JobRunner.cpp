#include "Widgets/Jobs/JobRunner.h"

#include <QElapsedTimer>
#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <exception>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr qint64 kBetweenReportsMs = 33;  // faster than the eye reads; keeps the event queue short

}  // namespace

/// A child of the runner, so that `done` may start the next job while this one's signal is still being
/// delivered.
struct JobRunner::Running : QObject {
  using QObject::QObject;
  QFutureWatcher<void> watcher;
  std::exception_ptr error;  // written by the worker before the watcher reports the end
};

JobRunner::JobRunner(Mode mode, QObject* parent) : QObject(parent), mode_(mode) {}

JobRunner::~JobRunner() {
  cancel();
  if (!running_) return;
  running_->watcher.disconnect();
  running_->watcher.waitForFinished();
}

void JobRunner::cancel() { stop_.request_stop(); }

bool JobRunner::run(const QString& title, std::function<void(const Progress&)> work,
                    std::function<void()> done, std::function<void()> stopped) {
  if (busy_) return false;
  busy_ = true;
  title_ = title;
  stop_ = std::stop_source();
  running_ = new Running(this);

  auto sinceReport = std::make_shared<QElapsedTimer>();
  auto lastStage = std::make_shared<QString>();
  Progress progress(
      [this, sinceReport, lastStage](double fraction, std::string_view stage) {
        const QString text = QString::fromUtf8(stage.data(), static_cast<int>(stage.size()));
        const bool news = !text.isEmpty() && text != *lastStage;
        if (!news && sinceReport->isValid() && sinceReport->elapsed() < kBetweenReportsMs) return;
        sinceReport->start();
        if (news) *lastStage = text;
        // Queued when called from the worker, direct in Inline mode; dropped if the runner is gone by then.
        QMetaObject::invokeMethod(this, [this, fraction, text] { Q_EMIT progressed(fraction, text); });
      },
      stop_.get_token());
  auto body = [work = std::move(work), progress, running = running_] {
    try {
      work(progress);
    } catch (...) {
      running->error = std::current_exception();
    }
  };

  Q_EMIT started(title);
  if (mode_ == Mode::Inline) {
    body();
    settle(done, stopped);
    return true;
  }
  connect(&running_->watcher, &QFutureWatcher<void>::finished, this,
          [this, done = std::move(done), stopped = std::move(stopped)] { settle(done, stopped); });
  running_->watcher.setFuture(QtConcurrent::run(std::move(body)));
  return true;
}

void JobRunner::settle(const std::function<void()>& done, const std::function<void()>& stopped) {
  const std::exception_ptr error = running_->error;
  running_->deleteLater();
  running_ = nullptr;
  busy_ = false;
  try {
    if (error) std::rethrow_exception(error);
    if (done) done();
  } catch (const Cancelled&) {
    if (stopped) stopped();
    Q_EMIT cancelled();
  } catch (const std::bad_alloc&) {
    Q_EMIT failed(tr("Not enough memory for \"%1\".").arg(title_));
  } catch (const InputError& e) {
    Q_EMIT failed(QString::fromUtf8(e.what()));
  } catch (const std::exception& e) {
    Q_EMIT failed(tr("Internal error in \"%1\": %2").arg(title_, QString::fromUtf8(e.what())));
  }
  Q_EMIT finished();
}

}  // namespace falciform
