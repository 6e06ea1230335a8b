#include "Modules/CommandLine/ToolTips.h"

#include "Logic/Core/LandmarkPairs.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/MarkupFiles.h"
#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

/// More than this is a tracker's log: a list of named points would not open in reasonable time.
constexpr std::size_t kMostMarkups = 5000;

Landmarks readTips(const fs::path& file, CommandRun& run) {
  const std::string extension = lowerCase(file.extension().string());
  if (extension == ".json" || extension == ".fcsv") return run.landmarks(file);
  if (extension != ".csv" && extension != ".xyz" && extension != ".txt")
    throw InputError("--tool-tips is '" + file.string() + "'; give points as .mrk.json, .fcsv, .csv or .xyz");
  const Surface table = run.surface(file);
  Landmarks tips;
  tips.frame = table.frame;
  for (Index i = 0; i < table.size(); ++i)
    tips.points.push_back({std::to_string(i + 1), table.points.row(i).transpose()});
  return tips;
}

std::string csvOf(const Landmarks& tips, const std::vector<PreopPlace>& places) {
  std::string csv =
      "name,scan_x_mm,scan_y_mm,scan_z_mm,preop_x_mm,preop_y_mm,preop_z_mm,inside,outside_mm,miss_mm\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::string name = tips.points[i].name;
    for (char& c : name)
      if (c == ',' || c == '"' || c == '\n') c = ' ';
    csv += name;
    for (const Vector3d& place : {tips.points[i].position, places[i].preop})
      for (int axis = 0; axis < 3; ++axis) csv += "," + fixed(place[axis], 4);
    csv += std::string(places[i].inside ? ",1," : ",0,") + fixed(places[i].outsideMm, 3) + "," +
           fixed(places[i].missMm, 4) + "\n";
  }
  return csv;
}

}  // namespace

std::vector<std::string> toolTipFiles() { return {"tool_tips_preop.mrk.json", "tool_tips_preop.csv"}; }

void writeToolTips(const fs::path& file, const UpdateMap& map, const std::string& preopFrame,
                   const fs::path& folder, CommandRun& run) {
  const Landmarks tips = readTips(file, run);
  const std::vector<PreopPlace> places = map.preopFromScan(positionsOf(tips));
  std::size_t inside = 0;
  Landmarks before;
  before.frame = preopFrame;
  double miss = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    before.points.push_back({tips.points[i].name, places[i].preop});
    inside += places[i].inside ? 1 : 0;
    miss = std::max(miss, places[i].missMm);
  }
  writeTextFile(run.outputs.staged(folder / "tool_tips_preop.csv"), Overwrite::Replace, csvOf(tips, places));
  if (places.size() <= kMostMarkups)
    writeLandmarks(run.outputs.staged(folder / "tool_tips_preop.mrk.json"), before, Overwrite::Replace);
  if (miss > 0.1)
    run.warn(
        "some tool tips lie in a cleft where the continued deformation folds over: their places are off by "
        "up to " +
        fixed(miss, 1) + " mm");
  run.figures["tool_tips"] = {{"count", places.size()}, {"inside", inside}};
  run.frames["tool_tips_preop"] = "where the tool tips are in the pre-op CT, patient LPS, mm";
  run.say("tool tips: " + std::to_string(places.size()) + ", " + std::to_string(inside) + " in the liver");
}

}  // namespace falciform::commandline
