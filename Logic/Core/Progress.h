#pragma once
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string_view>

namespace falciform {

/// Thrown by Progress::report when the user has asked for the job to stop. Not an error.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Reports how far a long computation has come, and stops it on request. Cheap to copy; any thread may hold
/// one, one thread at a time may report.
class Progress {
 public:
  /// Receives the fraction done, in [0, 1] of the whole job, and a short stage text.
  using Sink = std::function<void(double fraction, std::string_view stage)>;

  Progress() = default;  ///< Silent and never cancelled: the right default for tests and scripts.
  Progress(Sink sink, std::stop_token stop) : sink_(std::move(sink)), stop_(std::move(stop)) {}

  /// Reports a fraction in [0, 1] of this part; throws Cancelled if a stop was requested.
  void report(double fraction, std::string_view stage = {}) const {
    if (stop_.stop_requested()) throw Cancelled();
    if (sink_) sink_(from_ + fraction * (to_ - from_), stage);
  }

  [[nodiscard]] bool stopRequested() const { return stop_.stop_requested(); }

  /// The same progress restricted to [from, to] of this one, for one step of several.
  [[nodiscard]] Progress part(double from, double to) const {
    Progress step = *this;
    step.from_ = from_ + from * (to_ - from_);
    step.to_ = from_ + to * (to_ - from_);
    return step;
  }

 private:
  Sink sink_;
  std::stop_token stop_;
  double from_ = 0.0, to_ = 1.0;
};

}  // namespace falciform
