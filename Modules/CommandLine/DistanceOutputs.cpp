#include "Modules/CommandLine/DistanceOutputs.h"

#include <algorithm>
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
  std::string arrays =
      std::string(kSignedDistance) +
      " is positive where the scan lies outside the pre-op surface, NaN where neither reaches the other";
  if (map.preop.arrays.count(kCurvatureDifference) > 0)
    arrays += std::string("; ") + kCurvatureDifference +
              " is the scan's mean curvature less the pre-op surface's, positive where it is now more convex";
  run.frames["preop_distance.vtp"] = "the pre-op surface in the scan's frame, mm; " + arrays;
  run.frames["scan_distance.vtp"] = "the scan in its own frame, mm; " + arrays;
}

nlohmann::json distanceFigures(const DistanceMap& map) {
  nlohmann::json json = toJson(map);
  if (std::isfinite(map.preopAll.mean)) {
    json["mean_mm"] = map.preopAll.mean;
    json["rms_mm"] = map.preopAll.rms;
  }
  return json;
}

namespace {

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

/// One line a region; columns stand under each other.
void tellRegions(const std::vector<RegionFigures>& regions, const DistanceStatistics RegionFigures::*metric,
                 int decimals, CommandRun& run) {
  std::size_t width = 6;
  for (const RegionFigures& region : regions) width = std::max(width, region.name.size());
  const auto line = [&](const std::string& name, const std::vector<std::string>& cells) {
    std::string text = "  " + name + std::string(width - name.size(), ' ');
    for (const std::string& cell : cells) text += padded(cell, 10);
    run.say(text);
  };
  line("region",
       {"area cm2", "covered", "points", "mean", "SD", "median", "least", "greatest", "RMS", "P95"});
  for (const RegionFigures& region : regions) {
    const DistanceStatistics& s = region.*metric;
    std::vector<std::string> cells{fixed(region.areaMm2 / 100, 1), fixed(100 * region.coverage, 1) + " %",
                                   std::to_string(s.count)};
    for (const double value : {s.mean, s.sd, s.median, s.min, s.max, s.rms, s.p95Absolute})
      cells.push_back(fixed(value, decimals));
    line(region.name, cells);
  }
}

}  // namespace

void tellDistance(const DistanceMap& map, CommandRun& run) {
  run.say(
      "signed distance in mm: + where the scan lies outside the pre-op surface, - where inside it; P95 of "
      "the magnitude; places that are not covered enter no figure");
  run.say("from each vertex of the pre-op surface to the scan:");
  tellRegions(map.preopRegions, &RegionFigures::distance, 2, run);
  run.say("from each point of the scan to the pre-op surface:");
  tellRegions(map.scanRegions, &RegionFigures::distance, 2, run);
  if (map.preopRegions.front().curvatureDifference.count > 0) {
    run.say(
        "mean curvature of the scan less that of the pre-op surface in 1/mm, at the pre-op vertices: + where "
        "the liver is now more convex, - where flatter or hollow");
    tellRegions(map.preopRegions, &RegionFigures::curvatureDifference, 4, run);
  }
  run.say("the scan covers " + fixed(100 * map.coverage, 1) + " % of the pre-op surface");
}

}  // namespace falciform::commandline
