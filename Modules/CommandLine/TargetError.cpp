#include "Modules/CommandLine/TargetError.h"

#include <cmath>
#include <limits>
#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform::commandline {

namespace {

/// Truth in the order of the targets.
std::vector<Landmark> paired(const Landmarks& targets, const Landmarks& truth) {
  std::map<std::string, Landmark> byName;
  for (const Landmark& point : truth.points) byName[point.name] = point;
  std::vector<Landmark> ordered;
  std::map<std::string, int> seen;
  for (const Landmark& target : targets.points) {
    const auto found = byName.find(target.name);
    if (found == byName.end() || seen[target.name]++ > 0) return truth.points;
    ordered.push_back(found->second);
  }
  return ordered;
}

Points pointsOf(const std::vector<Landmark>& landmarks) {
  Points points(static_cast<Index>(landmarks.size()), 3);
  for (Index i = 0; i < points.rows(); ++i) points.row(i) = landmarks[static_cast<std::size_t>(i)].position;
  return points;
}

}  // namespace

PairedTargets pairTargets(const Landmarks& targets, const Landmarks& truth) {
  if (targets.points.empty() || targets.points.size() != truth.points.size())
    throw InputError("there are " + std::to_string(targets.points.size()) + " targets and " +
                     std::to_string(truth.points.size()) +
                     " true positions; give as many of both, at least one");
  return {pointsOf(targets.points), pointsOf(paired(targets, truth))};
}

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
