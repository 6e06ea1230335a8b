#include <chrono>

#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/LevelSet.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Modules/CommandLine/SeedInput.h"
#include "Modules/CommandLine/SegmentPicture.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "CT",
              .kind = File,
              .label = "CT",
              .help = "Hounsfield units: NIfTI, NRRD, MetaImage or a DICOM folder.",
              .required = true,
              .positional = true,
              .group = group});
  declareSeries(syntax, group, "that is the CT");
  declareSeeds(syntax, group,
               "Clicks in the organ, patient LPS mm. The first lies in the organ's own tissue; one in unlike "
               "tissue (a tumour) grows with its own brightness");
  syntax.add(
      {.name = "continue",
       .kind = LabelMap,
       .label = "Go on from",
       .help = "A label map on the CT's grid: what is above 0 stays organ, and the front goes on from it.",
       .group = group});
  syntax.add({.name = "forbidden",
              .kind = LabelMap,
              .label = "Forbidden",
              .help = "A label map on the CT's grid: what is above 0 never becomes organ.",
              .group = group});
  syntax.add(
      {.name = "out",
       .kind = LabelMap,
       .label = "Label map",
       .help =
           "Label map to write, 1 is the organ: .nii.gz, .nii, .nrrd, .mha; its sidecar is written beside "
           "it as FILE.json.",
       .required = true,
       .output = true,
       .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also write six slices with the outline, .png.",
              .output = true,
              .group = group});
  syntax.addSettings(LevelSetSettings{}, "Level set");
  syntax.addResult({"volume_ml", "Volume", "ml"});
  syntax.addResult({"neck_mm", "Narrowest neck passed", "mm"});
  syntax.addResult({"weak_border_share", "Border without an edge", ""});
}

nlohmann::json figuresOf(const LevelSetResult& result, double seconds) {
  nlohmann::json figures{{"volume_ml", result.volumeMl},
                         {"tissue_level_hu", result.tissueLevelHu},
                         {"tissue_spread_hu", result.tissueSpreadHu},
                         {"neck_mm", result.neckMm},
                         {"weak_border_share", result.weakBorderShare},
                         {"seconds", seconds},
                         {"left_out", nlohmann::json::array()},
                         {"enclosed", nlohmann::json::array()}};
  for (const LeftOut& part : result.leftOut)
    figures["left_out"].push_back({{"neck_mm", part.neckMm},
                                   {"volume_ml", part.volumeMl},
                                   {"place_lps_mm", {part.place.x(), part.place.y(), part.place.z()}}});
  for (const EnclosedPart& part : result.enclosed)
    figures["enclosed"].push_back({{"volume_ml", part.volumeMl},
                                   {"level_hu", part.levelHu},
                                   {"enclosed_share", part.enclosedShare},
                                   {"place_lps_mm", {part.place.x(), part.place.y(), part.place.z()}}});
  return figures;
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out"), picture = picturePath(arguments);
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  if (!picture.empty()) run.outputs.announce(picture);
  const auto settings = arguments.settings(LevelSetSettings{});
  run.settings["levelSet"] = settingsToJson(settings);
  run.frames = {{out.filename().string(), "patient LPS, mm; the CT's grid"}};

  const falciform::Points seeds = seedsOf(arguments, run);
  run.settings["seedsLpsMm"] = nlohmann::json::array();
  for (Index s = 0; s < seeds.rows(); ++s)
    run.settings["seedsLpsMm"].push_back({seeds(s, 0), seeds(s, 1), seeds(s, 2)});
  run.progress.report(0, "Reading the CT");
  const Image ct = run.image(arguments.path("CT"), arguments.text("series"));
  falciform::LabelMap start, forbidden;
  if (arguments.has("continue")) start = run.labelMap(arguments.path("continue"));
  if (arguments.has("forbidden")) forbidden = run.labelMap(arguments.path("forbidden"));

  const auto begin = std::chrono::steady_clock::now();
  const LevelSetResult result =
      segmentLevelSet({.ct = ct,
                       .seeds = seeds,
                       .start = arguments.has("continue") ? &start : nullptr,
                       .forbidden = arguments.has("forbidden") ? &forbidden : nullptr},
                      settings, run.progress.part(0.1, 0.92));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.warn(result.warnings);
  run.figures = figuresOf(result, seconds);
  run.progress.report(0.92, "Writing");
  writeLabelMap(run.outputs.staged(out), result.labels, Overwrite::Replace);
  if (!picture.empty())
    savePng(segmentPicture(ct, result.labels, seeds), run.outputs.staged(picture), Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
  run.say(out.string() + ": " + fixed(result.volumeMl, 0) + " ml of " + fixed(result.tissueLevelHu, 0) +
          " +- " + fixed(result.tissueSpreadHu, 0) + " HU, narrowest neck passed " + fixed(result.neckMm, 1) +
          " mm, " + fixed(100 * result.weakBorderShare, 0) + " % of the border without an edge, " +
          fixed(seconds, 1) + " s");
}

}  // namespace

Command segmentCommand() {
  return {"segment", "Segment organ", "Grows the liver in a CT from a few clicks by a level set.", declare,
          execute};
}

}  // namespace falciform::commandline
