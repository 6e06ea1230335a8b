#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "Logic/Core/Case.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/PreparedOnce.h"
#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform {

/// The registration step on a Case: settings, what is missing, a job from a snapshot, the result accepted.
class RegistrationLogic {
 public:
  using Job = std::function<RegistrationResult(const Progress&)>;

  explicit RegistrationLogic(Case& document) : case_(document) {}

  RegistrationSettings settings;
  bool startFromLandmarks = false;  ///< give the landmark fit as the start
  IterationObserver observer;       ///< called on the job's thread

  /// What is missing, one sentence, or empty.
  [[nodiscard]] std::string missingInput() const;
  /// The same for a registration from a given pose, which needs no patches.
  [[nodiscard]] std::string missingSurfaces() const;
  /// Why the landmarks give no start, or empty.
  [[nodiscard]] std::string missingLandmarks() const;
  /// The pose that the landmarks of both sides give, with the error of each; none while any is missing.
  [[nodiscard]] std::optional<PointRegistrationResult> landmarkFit() const;

  /// A job that any thread may run; it holds its own snapshot of the case.
  [[nodiscard]] Job prepare() const;
  /// The same from one pose, whatever the settings say of the start. The method auto looks everywhere; from a
  /// pose picp takes its place.
  [[nodiscard]] Job prepareFrom(const Isometry3d& scanFromPreopStart) const;
  /// A job that fills in the figures of a pose as it stands (PoseEvaluation.h).
  [[nodiscard]] Job prepareEvaluation(RegistrationResult pose, const Isometry3d& scanFromPreopStart) const;
  /// Main thread: stores the result in the case.
  void accept(RegistrationResult result);
  /// prepare, run and accept, for scripts and tests.
  const RegistrationResult& run(const Progress& progress = {});

 private:
  Case& case_;
  std::shared_ptr<PreparedOnce> prepared_ = std::make_shared<PreparedOnce>();
};

/// Pose `chosen` of the result's basins as the result: basins[0] from now on. Its figures are those of the
/// old pose until they are evaluated. Throws std::out_of_range.
[[nodiscard]] RegistrationResult withBasin(const RegistrationResult& result, std::size_t chosen);

}  // namespace falciform
