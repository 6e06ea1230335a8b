#pragma once
#include <functional>
#include <optional>

#include "Logic/Core/Case.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform {

/// The registration step on a Case: settings, what is missing, a job from a snapshot, the result accepted.
class RegistrationLogic {
 public:
  explicit RegistrationLogic(Case& document) : case_(document) {}

  RegistrationSettings settings;
  bool startFromLandmarks = false;  ///< give the landmark fit as the start
  IterationObserver observer;       ///< called on the job's thread

  /// What is missing, one sentence, or empty.
  [[nodiscard]] std::string missingInput() const;
  /// A job that any thread may run; it holds its own snapshot of the case.
  [[nodiscard]] std::function<RegistrationResult(const Progress&)> prepare() const;
  /// Main thread: stores the result in the case.
  void accept(RegistrationResult result);
  /// prepare, run and accept, for scripts and tests.
  const RegistrationResult& run(const Progress& progress = {});

 private:
  Case& case_;
};

}  // namespace falciform
