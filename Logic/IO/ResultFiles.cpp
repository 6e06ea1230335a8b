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

std::string row(const std::string& side, const std::string& patch, const DistanceStatistics& s) {
  std::string line = side + ',' + csvCell(patch) + ',' + std::to_string(s.count);
  for (const double value : {s.mean, s.sd, s.median, s.p95Absolute, s.min, s.max, s.rms, s.meanAbsolute})
    line += ',' + (std::isfinite(value) ? numberText(value) : std::string());
  return line + '\n';
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

Json toJson(const DistanceStatistics& s) {
  return {{"count", s.count},
          {"mean_mm", numberOrNull(s.mean)},
          {"sd_mm", numberOrNull(s.sd)},
          {"median_mm", numberOrNull(s.median)},
          {"p95_absolute_mm", numberOrNull(s.p95Absolute)},
          {"min_mm", numberOrNull(s.min)},
          {"max_mm", numberOrNull(s.max)},
          {"rms_mm", numberOrNull(s.rms)},
          {"mean_absolute_mm", numberOrNull(s.meanAbsolute)}};
}

Json toJson(const DistanceMap& map) {
  return {{"array", kSignedDistance},
          {"sign", "positive where the intra-operative surface lies outside the pre-operative one"},
          {"coverage", numberOrNull(map.coverage)},
          {"preop", {{"all", toJson(map.preopAll)}, {"patches", byPatch(map.preopByPatch, map.preop)}}},
          {"scan", {{"all", toJson(map.scanAll)}, {"patches", byPatch(map.scanByPatch, map.scan)}}}};
}

std::string toCsv(const DistanceMap& map) {
  std::string csv =
      "side,patch,count,mean_mm,sd_mm,median_mm,p95_absolute_mm,min_mm,max_mm,rms_mm,mean_absolute_mm\n";
  csv += row("preop", "all", map.preopAll);
  for (const auto& [label, values] : map.preopByPatch)
    csv += row("preop", patchName(map.preop, label), values);
  csv += row("scan", "all", map.scanAll);
  for (const auto& [label, values] : map.scanByPatch) csv += row("scan", patchName(map.scan, label), values);
  return csv;
}

}  // namespace falciform
