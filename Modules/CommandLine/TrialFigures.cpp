#include "Modules/CommandLine/TrialFigures.h"

#include "Logic/IO/JsonFile.h"

namespace falciform::commandline {

namespace {

nlohmann::json toJson(const SampleStatistics& s) {
  return {{"count", s.count},           {"mean", numberOrNull(s.mean)},
          {"sd", numberOrNull(s.sd)},   {"median", numberOrNull(s.median)},
          {"p95", numberOrNull(s.p95)}, {"p99", numberOrNull(s.p99)},
          {"max", numberOrNull(s.max)}};
}

nlohmann::json toJson(const TrialSummary& s, const std::string& name) {
  const Index failures = s.trials - s.successes;
  const auto share = [](Index part, Index whole) {
    return whole == 0 ? nlohmann::json()
                      : nlohmann::json(static_cast<double>(part) / static_cast<double>(whole));
  };
  return {{"method", name},
          {"trials", s.trials},
          {"successes", s.successes},
          {"success_share", share(s.successes, s.trials)},
          {"success_interval_95", {s.success.low, s.success.high}},
          {"success_at_least_95", s.success.atLeast},
          {"rms_mm", toJson(s.rmsMm)},
          {"rms_of_successes_mm", toJson(s.rmsOfSuccessesMm)},
          {"target_error_mm", toJson(s.targetErrorMm)},
          {"target_error_of_successes_mm", toJson(s.targetErrorOfSuccessesMm)},
          {"near_gold", s.nearGold},
          {"failures", failures},
          {"failures_flagged", s.failuresFlagged},
          {"failures_flagged_share", share(s.failuresFlagged, failures)},
          {"successes_flagged", s.successesFlagged},
          {"successes_flagged_share", share(s.successesFlagged, s.successes)},
          {"basins", s.basins},
          {"in_largest_basin", s.inLargestBasin},
          {"same_result_wherever_the_scan_lies", s.alike},
          {"iterations_of_successes", toJson(s.iterationsOfSuccesses)},
          {"time_s", toJson(s.seconds)},
          {"time_of_successes_s", toJson(s.secondsOfSuccesses)},
          {"time_per_iteration_of_successes_s", toJson(s.secondsPerIterationOfSuccesses)}};
}

}  // namespace

nlohmann::json trialSettingsJson(const TrialOutcome& outcome) {
  nlohmann::json trials = settingsToJson(outcome.settings);
  trials.erase("seed");  // stands with the provenance, as everywhere
  nlohmann::json methods = nlohmann::json::object();
  for (const TrialMethod& method : outcome.methods) methods[method.name] = settingsToJson(method.settings);
  return {{"trials", trials},
          {"scan_variation", settingsToJson(outcome.settings.variation)},
          {"scale", settingsToJson(outcome.scale)},
          {"scale_name", outcome.scaleName},
          {"methods", methods}};
}

nlohmann::json trialFigures(const TrialOutcome& outcome) {
  nlohmann::json methods = nlohmann::json::array();
  for (std::size_t i = 0; i < outcome.methods.size(); ++i)
    methods.push_back(toJson(outcome.summaries[i], outcome.methods[i].name));
  return {{"gold_standard",
           {{"source", outcome.gold.source},
            {"scan_from_preop", matrixToJson(outcome.gold.scanFromPreop)},
            {"rms_mm", outcome.gold.rmsMm},
            {"target_error_mm", numberOrNull(outcome.gold.targetErrorMm)}}},
          {"success_is_by", outcome.targets > 0 ? "target error" : "RMS residual"},
          {"targets", outcome.targets},
          {"optimal_rigid_target_error_mm", numberOrNull(outcome.optimalRigidMm)},
          {"preop_points", outcome.preopPoints},
          {"scan_points", outcome.scanPoints},
          {"preparation_time_s", outcome.preparationSeconds},
          {"methods", methods}};
}

}  // namespace falciform::commandline
