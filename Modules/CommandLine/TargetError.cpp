#include "Modules/CommandLine/TargetError.h"

#include <cmath>
#include <limits>

#include "Logic/Registration/PointRegistration.h"

namespace falciform::commandline {

TargetError measureTargetError(const Landmarks& targets, const Landmarks& truth,
                               const RegistrationResult& registration, const Isometry3d& scanFromPreopStart) {
  const auto [source, target] = pairTargets(targets, truth);
  TargetError error;
  for (const Landmark& point : targets.points) error.names.push_back(point.name);
  error.errorsMm = registration.warp
                       ? VectorXd((registration.warp->scanFromPreop(source) - target).rowwise().norm())
                       : targetErrors(source, target, registration.scanFromPreop);
  if (registration.expectedTargetErrorMm) {
    error.expectedMm.resize(source.rows());
    for (Index i = 0; i < source.rows(); ++i)
      error.expectedMm[i] = registration.expectedTargetErrorMm(source.row(i).transpose());
  }
  error.meanMm = error.errorsMm.mean();
  error.rmsMm = std::sqrt(error.errorsMm.squaredNorm() / static_cast<double>(error.errorsMm.size()));
  error.maxMm = error.errorsMm.maxCoeff();
  error.startMeanMm = targetErrors(source, target, scanFromPreopStart).mean();
  error.optimalRigidMeanMm = source.rows() < 3
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : targetErrors(source, target, fitRigid(source, target)).mean();
  return error;
}

nlohmann::json toJson(const TargetError& error) {
  nlohmann::json targets = nlohmann::json::array();
  for (std::size_t i = 0; i < error.names.size(); ++i) {
    const auto row = static_cast<Index>(i);
    targets.push_back({{"name", error.names[i]}, {"error_mm", error.errorsMm[row]}});
    if (error.expectedMm.size() > row) targets.back()["expected_mm"] = error.expectedMm[row];
  }
  nlohmann::json json{{"mean_mm", error.meanMm},
                      {"rms_mm", error.rmsMm},
                      {"max_mm", error.maxMm},
                      {"start_mean_mm", error.startMeanMm},
                      {"targets", targets}};
  if (error.expectedMm.size() > 0) json["expected_mean_mm"] = error.expectedMm.mean();
  json["optimal_rigid_mean_mm"] =
      std::isnan(error.optimalRigidMeanMm) ? nlohmann::json() : nlohmann::json(error.optimalRigidMeanMm);
  return json;
}

}  // namespace falciform::commandline
