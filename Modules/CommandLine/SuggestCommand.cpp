#include <algorithm>

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Patches/FeatureSuggestions.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Modules/CommandLine/SuggestPicture.h"

namespace falciform::commandline {

namespace {

constexpr Index kTellEveryMm = 5;  ///< points of the lines in the sidecar

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "out",
              .kind = Surface,
              .label = "Painted surface",
              .help =
                  "The surface with the suggested patches; .vtp, .vtk and .ply keep them. All candidates and "
                  "their lines are in its sidecar, FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also write a picture of the painted surface, .png.",
              .output = true,
              .group = group});
  syntax.add({.name = "SURFACE",
              .kind = Surface,
              .label = "Liver surface",
              .help = "Pre-operative surface of the liver, mm, with triangles.",
              .required = true,
              .positional = true,
              .group = group});
  const std::string what = "Suggestions";
  syntax.add({.name = "feature",
              .kind = Text,
              .label = "Features",
              .help = "What to paint: ridge, falciform, or both, comma-separated.",
              .fallback = "ridge,falciform",
              .group = what});
  syntax.add(
      {.name = "frame",
       .kind = Text,
       .label = "Frame",
       .help = "Which sides of the patient the surface's x, y and z run towards: three letters, one of each "
               "of R/L, A/P and S/I.",
       .fallback = "LPS",
       .group = what});
  syntax.add({.name = "ridge-candidate",
              .kind = Integer,
              .label = "Ridge candidate",
              .help = "Which candidate for the ridge is painted, 1 for the best.",
              .fallback = "1",
              .min = 1,
              .max = 5,
              .group = what});
  syntax.add({.name = "groove-candidate",
              .kind = Integer,
              .label = "Groove candidate",
              .help = "Which candidate for the falciform groove is painted, 1 for the best.",
              .fallback = "1",
              .min = 1,
              .max = 5,
              .group = what});
  syntax.add({.name = "keep-old",
              .kind = Flag,
              .label = "Keep old patches",
              .help = "What is painted on the surface already stays, and suggestions go over it.",
              .group = what});
  syntax.addSettings(SuggestionSettings{}, what);
  syntax.addResult({"ridge_score", "Ridge score", ""});
  syntax.addResult({"groove_score", "Groove score", ""});
}

struct Wanted {
  bool ridge = false, groove = false;
};

Wanted wantedFeatures(const std::string& list) {
  Wanted wanted;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    if (word == "ridge")
      wanted.ridge = true;
    else if (word == "falciform")
      wanted.groove = true;
    else
      throw InputError("--feature names '" + word +
                       "'; choose ridge, falciform, or both with a comma between");
    begin = end + 1;
  }
  return wanted;
}

nlohmann::json toJson(const FeatureSuggestion& s) {
  nlohmann::json line = nlohmann::json::array();
  for (Index i = 0; i < s.line.rows(); i += kTellEveryMm)
    line.push_back({s.line(i, 0), s.line(i, 1), s.line(i, 2)});
  return {{"what", s.what},
          {"score", s.score},
          {"length_mm", s.lengthMm},
          {"points", s.vertices.size()},
          {"line_mm", std::move(line)}};
}

/// Tells of all candidates and paints one; nothing where there is none.
void take(const std::vector<FeatureSuggestion>& candidates, int number, const std::string& name,
          const std::string& key, falciform::Surface& surface, CommandRun& run) {
  nlohmann::json all = nlohmann::json::array();
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const FeatureSuggestion& s = candidates[c];
    all.push_back(toJson(s));
    run.say(name + " " + std::to_string(c + 1) + ": " + s.what + ", " + fixed(s.lengthMm, 0) + " mm, " +
            std::to_string(s.vertices.size()) + " points, score " + fixed(s.score, 2) +
            (static_cast<int>(c) + 1 == number ? ", painted" : ""));
  }
  run.figures[key + "_candidates"] = std::move(all);
  if (candidates.empty()) return;
  const auto chosen = static_cast<std::size_t>(number) - 1;
  if (chosen >= candidates.size())
    throw InputError("--" + key + "-candidate is " + std::to_string(number) + ", and there are " +
                     std::to_string(candidates.size()) + " candidates; choose one of them");
  run.figures[key + "_score"] = candidates[chosen].score;
  surface.patch = paintedLabels(surface, candidates[chosen]);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out"), picture = picturePath(arguments);
  const Wanted wanted = wantedFeatures(arguments.text("feature"));
  const AnatomicalAxes axes = axesFromLetters(arguments.text("frame"));
  const auto settings = arguments.settings(SuggestionSettings{});
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  if (!picture.empty()) run.outputs.announce(picture);
  run.settings["suggestions"] = settingsToJson(settings);
  run.settings["suggestions"]["frame"] = arguments.text("frame");
  falciform::Surface surface = run.surface(arguments.path("SURFACE"));
  if (!arguments.has("keep-old")) surface.patch.clear();
  const FeatureSuggestions all = suggestFeatures(surface, settings, axes, run.progress);
  run.warn(all.warnings);
  // The ridge first: where the two meet at the notch, the groove is the smaller.
  if (wanted.ridge) take(all.ridge, arguments.integer("ridge-candidate"), "ridge", "ridge", surface, run);
  if (wanted.groove)
    take(all.groove, arguments.integer("groove-candidate"), "groove", "groove", surface, run);
  run.figures["patches"] = commandline::toJson(patchStatistics(surface));
  run.frames = {{out.filename().string(), surface.frame}};
  writeSurface(run.outputs.staged(out), surface, Overwrite::Replace);
  if (!picture.empty())
    savePng(suggestPicture(surface, axes), run.outputs.staged(picture), Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
}

}  // namespace

Command suggestCommand() {
  return {"suggest", "Suggest features",
          "Finds the inferior ridge and the falciform groove of a liver and paints them as patches.", declare,
          execute};
}

}  // namespace falciform::commandline
