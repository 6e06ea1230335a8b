#include "Logic/IO/ResultFiles.h"

#include <cmath>

#include "Logic/IO/CsvTable.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

using Json = nlohmann::json;

Json toJson(const IterationRecord& record) {
  return {{"iteration", record.iteration},
          {"rms_mm", numberOrNull(record.rmsMm)},
          {"patch_weight", numberOrNull(record.patchWeight)},
          {"motion_mm", numberOrNull(record.motionMm)},
          {"preop_from_scan", matrixToJson(record.preopFromScan)}};
}

Json toJson(const RegistrationBasin& basin) {
  return {{"scan_from_preop", matrixToJson(basin.scanFromPreop)},
          {"score", numberOrNull(basin.score)},
          {"starts", basin.starts}};
}

Json byPatch(const std::map<int, DistanceStatistics>& statistics, const Surface& surface) {
  Json list = Json::array();
  for (const auto& [label, values] : statistics) {
    Json entry = toJson(values);
    entry["label"] = label;
    entry["patch"] = patchName(surface, label);
    list.push_back(entry);
  }
  return list;
}

/// "mean_per_mm" with `unit` "_per_mm".
Json withUnit(const DistanceStatistics& s, const std::string& unit) {
  return {{"count", s.count},
          {"mean" + unit, numberOrNull(s.mean)},
          {"sd" + unit, numberOrNull(s.sd)},
          {"median" + unit, numberOrNull(s.median)},
          {"p95_absolute" + unit, numberOrNull(s.p95Absolute)},
          {"min" + unit, numberOrNull(s.min)},
          {"max" + unit, numberOrNull(s.max)},
          {"rms" + unit, numberOrNull(s.rms)},
          {"mean_absolute" + unit, numberOrNull(s.meanAbsolute)}};
}

Json regionsToJson(const std::vector<RegionFigures>& regions) {
  Json list = Json::array();
  for (const RegionFigures& region : regions)
    list.push_back({{"region", region.name},
                    {"kind", regionKindName(region.kind)},
                    {"label", region.label},
                    {"area_mm2", numberOrNull(region.areaMm2)},
                    {"covered_area_mm2", numberOrNull(region.coveredAreaMm2())},
                    {"coverage", numberOrNull(region.coverage)},
                    {"signed_distance", withUnit(region.distance, "_mm")},
                    {"curvature_difference", withUnit(region.curvatureDifference, "_per_mm")}});
  return list;
}

std::string cells(const DistanceStatistics& s) {
  std::string line = ',' + std::to_string(s.count);
  for (const double value : {s.mean, s.sd, s.median, s.p95Absolute, s.min, s.max, s.rms, s.meanAbsolute})
    line += ',' + (std::isfinite(value) ? numberText(value) : std::string());
  return line;
}

std::string rows(const std::string& side, const std::vector<RegionFigures>& regions) {
  std::string csv;
  for (const RegionFigures& region : regions) {
    csv += side + ',' + csvCell(region.name) + ',' + regionKindName(region.kind);
    for (const double value : {region.areaMm2, region.coveredAreaMm2(), region.coverage})
      csv += ',' + (std::isfinite(value) ? numberText(value) : std::string());
    csv += cells(region.distance) + cells(region.curvatureDifference) + '\n';
  }
  return csv;
}

}  // namespace

Json toJson(const RegistrationResult& result) {
  Json patches = Json::object(), history = Json::array(), basins = Json::array();
  for (const auto& [label, rms] : result.patchRmsMm) patches[std::to_string(label)] = numberOrNull(rms);
  for (const IterationRecord& record : result.history) history.push_back(toJson(record));
  for (const RegistrationBasin& basin : result.basins) basins.push_back(toJson(basin));
  return {{"scan_from_preop", matrixToJson(result.scanFromPreop)},
          {"direction", "scan_from_preop maps pre-op LPS mm to scan mm"},
          {"note", "residuals are fit, not target error"},
          {"rms_mm", numberOrNull(result.rmsMm)},
          {"weighted_rms_mm", numberOrNull(result.weightedRmsMm)},
          {"mean_mm", numberOrNull(result.meanMm)},
          {"p95_mm", numberOrNull(result.p95Mm)},
          {"patch_rms_mm", patches},
          {"coverage", numberOrNull(result.coverage)},
          {"expected_target_error_mm",
           result.expectedErrorMeanMm > 0 ? nlohmann::json(result.expectedErrorMeanMm) : nlohmann::json()},
          {"rotation_deg", numberOrNull(result.rotationDeg)},
          {"translation_mm", numberOrNull(result.translationMm)},
          {"iterations", result.iterations},
          {"converged", result.converged},
          {"stop_reason", result.stopReason},
          {"scan_points", result.scanPoints},
          {"preop_points", result.preopPoints},
          {"seconds", numberOrNull(result.seconds)},
          {"warnings", result.warnings},
          {"basins", basins},
          {"history", history}};
}

Json toJson(const DistanceStatistics& s) { return withUnit(s, "_mm"); }

Json toJson(const DistanceMap& map) {
  const auto side = [](const DistanceStatistics& all, const std::map<int, DistanceStatistics>& patches,
                       const std::vector<RegionFigures>& regions, const Surface& surface) {
    return Json{
        {"all", toJson(all)}, {"patches", byPatch(patches, surface)}, {"regions", regionsToJson(regions)}};
  };
  return {{"array", kSignedDistance},
          {"sign", "positive where the intra-operative surface lies outside the pre-operative one"},
          {"direction",
           "preop: from each vertex of the pre-operative surface to the scan; scan: from each point of the "
           "scan to the pre-operative surface"},
          {"curvature_array", kCurvatureDifference},
          {"curvature_sign",
           "mean curvature of the intra-operative surface less that of the pre-operative one: positive where "
           "it has become more convex"},
          {"coverage", numberOrNull(map.coverage)},
          {"preop", side(map.preopAll, map.preopByPatch, map.preopRegions, map.preop)},
          {"scan", side(map.scanAll, map.scanByPatch, map.scanRegions, map.scan)}};
}

std::string toCsv(const DistanceMap& map) {
  std::string csv = "side,region,kind,area_mm2,covered_area_mm2,coverage";
  for (const char* metric : {"", "curvature_difference_"}) {
    const std::string name = metric, unit = name.empty() ? "_mm" : "_per_mm";
    csv += ',' + name + "count";
    for (const char* figure : {"mean", "sd", "median", "p95_absolute", "min", "max", "rms", "mean_absolute"})
      csv += ',' + name + figure + unit;
  }
  return csv + '\n' + rows("preop", map.preopRegions) + rows("scan", map.scanRegions);
}

std::string regionKindName(RegionFigures::Kind kind) {
  switch (kind) {
    case RegionFigures::Kind::Patch:
      return "patch";
    case RegionFigures::Kind::Segment:
      return "segment";
    case RegionFigures::Kind::All:
      break;
  }
  return "all";
}

}  // namespace falciform
