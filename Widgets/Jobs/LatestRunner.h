#pragma once
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "Widgets/Jobs/JobRunner.h"

namespace falciform {

/// Runs short pieces of work that follow each other quickly, as a slider asks for them, away from the window:
/// one at a time, and of those that come meanwhile only the newest. So what is shown lags by at most two of
/// them, however fast the slider moves. Destroying it waits for the running one; its result is dropped.
class LatestRunner : public QObject {
  Q_OBJECT

 public:
  explicit LatestRunner(JobRunner::Mode mode = JobRunner::Mode::Background, QObject* parent = nullptr);
  ~LatestRunner() override;

  /// Runs `work() -> Result` on a worker thread, then `done(Result)` on the owner's.
  template <class Work, class Done>
  void submit(Work work, Done done) {
    using Result = std::invoke_result_t<Work>;
    auto result = std::make_shared<std::optional<Result>>();
    take({[result, work = std::move(work)] { result->emplace(work()); },
          [result, done = std::move(done)] { done(std::move(**result)); }});
  }

  /// Forgets what waits, and drops the result of what runs.
  void drop();
  [[nodiscard]] bool busy() const { return running_ != nullptr; }

 Q_SIGNALS:
  /// The newest work could not be done, and why.
  void failed(const QString& message);

 private:
  struct Job {
    std::function<void()> work, done;
  };
  struct Running;

  void take(Job job);
  void start(Job job);
  void settle();

  JobRunner::Mode mode_;
  std::optional<Job> waiting_;
  Running* running_ = nullptr;
};

}  // namespace falciform
