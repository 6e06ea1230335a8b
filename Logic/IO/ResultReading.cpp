#include <cmath>
#include <limits>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/ResultFiles.h"

namespace falciform {

namespace {

using Json = nlohmann::json;

/// Reads members one by one; each refusal names its key.
class Fields {
 public:
  Fields(const Json& json, std::string what) : json_(json), what_(std::move(what)) {
    if (!json.is_object()) throw InputError(what_ + " is no JSON object; save the case again");
  }

  double number(const char* key) const {
    const Json& value = at(key);
    if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!value.is_number()) refuse(key, "a number");
    return value.get<double>();
  }
  template <class Whole>
  Whole whole(const char* key) const {
    if (!at(key).is_number_integer()) refuse(key, "a whole number");
    return at(key).get<Whole>();
  }
  bool truth(const char* key) const {
    if (!at(key).is_boolean()) refuse(key, "true or false");
    return at(key).get<bool>();
  }
  std::string text(const char* key) const {
    if (!at(key).is_string()) refuse(key, "a text");
    return at(key).get<std::string>();
  }
  const Json& list(const char* key) const {
    if (!at(key).is_array()) refuse(key, "a list");
    return at(key);
  }
  Isometry3d rigid(const char* key) const { return rigidFromJson(at(key), what_ + ": " + key); }

  const Json& at(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) throw InputError(what_ + " lacks '" + key + "'; save the case again");
    return *found;
  }
  [[noreturn]] void refuse(const char* key, const char* expected) const {
    throw InputError(what_ + ": '" + key + "' is not " + expected + "; save the case again");
  }

 private:
  const Json& json_;
  std::string what_;
};

DistanceStatistics statisticsFrom(const Fields& fields, const std::string& unit = "_mm") {
  const auto number = [&](const std::string& figure) { return fields.number((figure + unit).c_str()); };
  DistanceStatistics s;
  s.count = fields.whole<Index>("count");
  s.mean = number("mean");
  s.sd = number("sd");
  s.median = number("median");
  s.p95Absolute = number("p95_absolute");
  s.min = number("min");
  s.max = number("max");
  s.rms = number("rms");
  s.meanAbsolute = number("mean_absolute");
  return s;
}

RegionFigures regionFrom(const Fields& fields) {
  using enum RegionFigures::Kind;
  RegionFigures region;
  const std::string kind = fields.text("kind");
  if (kind != "all" && kind != "patch" && kind != "segment") fields.refuse("kind", "all, patch or segment");
  region.kind = kind == "patch" ? Patch : kind == "segment" ? Segment : All;
  region.name = fields.text("region");
  region.label = fields.whole<int>("label");
  region.areaMm2 = fields.number("area_mm2");
  region.coverage = fields.number("coverage");
  region.distance = statisticsFrom(Fields(fields.at("signed_distance"), "the distances of a region"));
  region.curvatureDifference =
      statisticsFrom(Fields(fields.at("curvature_difference"), "the curvatures of a region"), "_per_mm");
  return region;
}

/// Of a case that was saved before regions were: what it knows of them.
std::vector<RegionFigures> regionsOf(const DistanceStatistics& all,
                                     const std::map<int, DistanceStatistics>& byPatch,
                                     const Surface& surface) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const DistanceStatistics nothing{0, none, none, none, none, none, none, none, none};
  std::vector<RegionFigures> regions{{RegionFigures::Kind::All, 0, "all", none, none, all, nothing}};
  for (const auto& [label, statistics] : byPatch)
    regions.push_back(
        {RegionFigures::Kind::Patch, label, patchName(surface, label), none, none, statistics, nothing});
  return regions;
}

void readSide(const Json& json, const char* side, const Surface& surface, DistanceStatistics& all,
              std::map<int, DistanceStatistics>& byPatch, std::vector<RegionFigures>& regions) {
  const Fields fields(json, std::string("the distance map's ") + side);
  all = statisticsFrom(Fields(fields.at("all"), "the distance statistics"));
  for (const Json& entry : fields.list("patches")) {
    const Fields patch(entry, "the distance statistics of a patch");
    byPatch[patch.whole<int>("label")] = statisticsFrom(patch);
  }
  if (!json.contains("regions")) {
    regions = regionsOf(all, byPatch, surface);
    return;
  }
  for (const Json& entry : fields.list("regions"))
    regions.push_back(regionFrom(Fields(entry, "the figures of a region")));
}

}  // namespace

RegistrationResult registrationFromJson(const Json& json) {
  const Fields fields(json, "the registration");
  RegistrationResult result;
  result.scanFromPreop = fields.rigid("scan_from_preop");
  result.rmsMm = fields.number("rms_mm");
  result.weightedRmsMm = fields.number("weighted_rms_mm");
  result.meanMm = fields.number("mean_mm");
  result.p95Mm = fields.number("p95_mm");
  if (!fields.at("patch_rms_mm").is_object()) fields.refuse("patch_rms_mm", "an object");
  for (const auto& [label, unused] : fields.at("patch_rms_mm").items()) {
    int number = 0;
    if (!parseNumber(std::string_view(label), number)) fields.refuse("patch_rms_mm", "keyed by label");
    result.patchRmsMm[number] = Fields(fields.at("patch_rms_mm"), "patch_rms_mm").number(label.c_str());
  }
  result.coverage = fields.number("coverage");
  const double expected = fields.number("expected_target_error_mm");  // null where the method gives none
  result.expectedErrorMeanMm = std::isfinite(expected) ? expected : 0;
  result.rotationDeg = fields.number("rotation_deg");
  result.translationMm = fields.number("translation_mm");
  result.iterations = fields.whole<int>("iterations");
  result.converged = fields.truth("converged");
  result.stopReason = fields.text("stop_reason");
  result.scanPoints = fields.whole<Index>("scan_points");
  result.preopPoints = fields.whole<Index>("preop_points");
  result.seconds = fields.number("seconds");
  for (const Json& warning : fields.list("warnings"))
    if (warning.is_string()) result.warnings.push_back(warning.get<std::string>());
  for (const Json& entry : fields.list("basins")) {
    const Fields basin(entry, "a basin");
    result.basins.push_back(
        {basin.rigid("scan_from_preop"), basin.number("score"), basin.whole<int>("starts")});
  }
  for (const Json& entry : fields.list("history")) {
    const Fields record(entry, "an iteration");
    result.history.push_back({record.whole<int>("iteration"), record.number("rms_mm"),
                              record.number("patch_weight"), record.number("motion_mm"),
                              record.rigid("preop_from_scan")});
  }
  return result;
}

DistanceMap distanceFromJson(const Json& json, Surface preop, Surface scan) {
  const Fields fields(json, "the distance map");
  DistanceMap map;
  map.coverage = fields.number("coverage");
  readSide(fields.at("preop"), "preop", preop, map.preopAll, map.preopByPatch, map.preopRegions);
  readSide(fields.at("scan"), "scan", scan, map.scanAll, map.scanByPatch, map.scanRegions);
  map.preop = std::move(preop);
  map.scan = std::move(scan);
  return map;
}

}  // namespace falciform
