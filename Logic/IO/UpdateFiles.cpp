#include "Logic/IO/UpdateFiles.h"

#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"

namespace falciform {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& key, const std::string& expected) {
  throw InputError("the saved update: '" + key + "' must be " + expected + "; update the model again");
}

const Json& member(const Json& json, const char* key) {
  if (!json.is_object() || !json.contains(key)) refuse(key, "there");
  return json[key];
}

double number(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_number()) refuse(key, "a number");
  return value.get<double>();
}

std::string text(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_string()) refuse(key, "a text");
  return value.get<std::string>();
}

bool truth(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_boolean()) refuse(key, "true or false");
  return value.get<bool>();
}

Json placeToJson(const Vector3d& place) { return {place.x(), place.y(), place.z()}; }

Vector3d place(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_array() || value.size() != 3) refuse(key, "three numbers");
  Vector3d result;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!value[k].is_number()) refuse(key, "three numbers");
    result[static_cast<Index>(k)] = value[k].get<double>();
  }
  return result;
}

std::optional<double> known(const Json& json, const char* key) {
  if (member(json, key).is_null()) return std::nullopt;
  return number(json, key);
}

Json optionalToJson(const std::optional<double>& value) {
  return value ? numberOrNull(*value) : Json(nullptr);
}

UpdatedTarget targetFrom(const Json& json) {
  UpdatedTarget target;
  target.name = text(json, "name");
  target.structure = truth(json, "structure");
  target.before = place(json, "before_preop_mm");
  target.rigid = place(json, "rigid_scan_mm");
  target.now = place(json, "now_scan_mm");
  target.expectedErrorMm = number(json, "expected_error_mm");
  target.trueErrorMm = known(json, "true_error_mm");
  target.rigidErrorMm = known(json, "rigid_error_mm");
  return target;
}

}  // namespace

Json toJson(const KeptUpdate& update) {
  Json targets = Json::array();
  for (const UpdatedTarget& target : update.targets)
    targets.push_back({{"name", target.name},
                       {"structure", target.structure},
                       {"before_preop_mm", placeToJson(target.before)},
                       {"rigid_scan_mm", placeToJson(target.rigid)},
                       {"now_scan_mm", placeToJson(target.now)},
                       {"expected_error_mm", target.expectedErrorMm},
                       {"true_error_mm", optionalToJson(target.trueErrorMm)},
                       {"rigid_error_mm", optionalToJson(target.rigidErrorMm)}});
  return {{"scan_from_preop", matrixToJson(update.scanFromPreop)},
          {"expected_error_mean_mm", update.expectedErrorMeanMm},
          {"rms_mm", update.rmsMm},
          {"bending_mm", update.bendMm},
          {"largest_displacement_mm", update.largestMm},
          {"min_det_j", update.minDetJ},
          {"loads_determined", update.effectiveParameters},
          {"update_s", update.seconds},
          {"iterations", update.iterations},
          {"converged", update.converged},
          {"stop_reason", update.stopReason},
          {"warnings", update.warnings},
          {"targets", std::move(targets)}};
}

KeptUpdate keptUpdateFromJson(const Json& json) {
  KeptUpdate update;
  update.scanFromPreop = rigidFromJson(member(json, "scan_from_preop"), "the saved update: scan_from_preop");
  update.expectedErrorMeanMm = number(json, "expected_error_mean_mm");
  update.rmsMm = number(json, "rms_mm");
  update.bendMm = number(json, "bending_mm");
  update.largestMm = number(json, "largest_displacement_mm");
  update.minDetJ = number(json, "min_det_j");
  update.effectiveParameters = number(json, "loads_determined");
  update.seconds = number(json, "update_s");
  if (!member(json, "iterations").is_number_integer()) refuse("iterations", "a whole number");
  update.iterations = json["iterations"].get<int>();
  update.converged = truth(json, "converged");
  update.stopReason = text(json, "stop_reason");
  if (!member(json, "warnings").is_array()) refuse("warnings", "a list of texts");
  for (const Json& warning : json["warnings"]) {
    if (!warning.is_string()) refuse("warnings", "a list of texts");
    update.warnings.push_back(warning.get<std::string>());
  }
  if (!member(json, "targets").is_array()) refuse("targets", "a list of objects");
  for (const Json& target : json["targets"]) update.targets.push_back(targetFrom(target));
  return update;
}

}  // namespace falciform
