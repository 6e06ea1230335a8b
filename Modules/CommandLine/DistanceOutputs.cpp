#include "Modules/CommandLine/DistanceOutputs.h"

#include <cmath>

#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

std::vector<std::string> distanceFiles() {
  return {"preop_distance.vtp", "scan_distance.vtp", "distance.csv"};
}

void writeDistance(const DistanceMap& map, const std::filesystem::path& folder, CommandRun& run) {
  writeSurface(run.outputs.staged(folder / "preop_distance.vtp"), map.preop, Overwrite::Replace);
  writeSurface(run.outputs.staged(folder / "scan_distance.vtp"), map.scan, Overwrite::Replace);
  writeTextFile(run.outputs.staged(folder / "distance.csv"), Overwrite::Replace, toCsv(map));
  run.frames["preop_distance.vtp"] =
      "the pre-op surface in the scan's frame, mm; " + std::string(kSignedDistance) +
      " is positive where the scan lies outside it, NaN where the scan does not reach";
  run.frames["scan_distance.vtp"] = "the scan in its own frame, mm";
}

nlohmann::json distanceFigures(const DistanceMap& map) {
  nlohmann::json json = toJson(map);
  if (std::isfinite(map.preopAll.mean)) {
    json["mean_mm"] = map.preopAll.mean;
    json["rms_mm"] = map.preopAll.rms;
  }
  return json;
}

void tellDistance(const DistanceMap& map, CommandRun& run) {
  const auto side = [&](const std::string& name, const DistanceStatistics& s) {
    run.say("distance on the " + name + ": mean " + fixed(s.mean, 2) + ", SD " + fixed(s.sd, 2) +
            ", median " + fixed(s.median, 2) + ", P95 of the magnitude " + fixed(s.p95Absolute, 2) +
            ", from " + fixed(s.min, 2) + " to " + fixed(s.max, 2) + " mm (" + std::to_string(s.count) +
            " points)");
  };
  side("pre-op surface", map.preopAll);
  side("scan", map.scanAll);
  run.say("the scan covers " + fixed(100 * map.coverage, 1) + " % of the pre-op surface");
}

}  // namespace falciform::commandline
