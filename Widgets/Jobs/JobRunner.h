#pragma once
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

#include "Logic/Core/Progress.h"

namespace falciform {

/// Runs one job at a time away from the window, and hands its result back on the thread that owns the runner.
/// Errors and cancellation end here: this, LatestRunner and the command line's `main` alone catch them.
/// Destroying the runner asks the job to stop and waits for it; its result is dropped.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  /// Inline runs the job within start(): for tests.
  enum class Mode { Background, Inline };

  explicit JobRunner(Mode mode = Mode::Background, QObject* parent = nullptr);
  ~JobRunner() override;

  /// Runs `work(progress) -> Result` on a worker thread, then `done(Result)` here. `stopped` is called here
  /// instead if the job was cancelled. Refused (false, nothing happens) while another job runs.
  template <class Work, class Done>
  bool start(const QString& title, Work work, Done done, std::function<void()> stopped = {}) {
    using Result = std::invoke_result_t<Work, const Progress&>;
    if constexpr (std::is_void_v<Result>) {
      return run(title, std::move(work), std::move(done), std::move(stopped));
    } else {
      auto result = std::make_shared<std::optional<Result>>();
      return run(
          title,
          [result, work = std::move(work)](const Progress& progress) { result->emplace(work(progress)); },
          [result, done = std::move(done)] { done(std::move(**result)); }, std::move(stopped));
    }
  }

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] bool busy() const { return busy_; }
  [[nodiscard]] const QString& title() const { return title_; }
  /// Asks the running job to stop; returns at once. It ends at its next progress report.
  void cancel();

 Q_SIGNALS:
  void started(const QString& title);
  /// At most some 30 a second, on the owner's thread.
  void progressed(double fraction, const QString& stage);
  void failed(const QString& message);
  void cancelled();
  /// Whatever the outcome, and after `done`.
  void finished();

 private:
  struct Running;

  bool run(const QString& title, std::function<void(const Progress&)> work, std::function<void()> done,
           std::function<void()> stopped);
  void settle(const std::function<void()>& done, const std::function<void()>& stopped);

  Mode mode_;
  bool busy_ = false;
  QString title_;
  std::stop_source stop_;
  Running* running_ = nullptr;
};

}  // namespace falciform
