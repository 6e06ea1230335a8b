#include "Modules/CommandLine/TrialInputs.h"

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"
#include "Modules/CommandLine/TargetError.h"

namespace falciform::commandline {

namespace {

Points pointsOf(const nlohmann::json& json, const char* key, const std::filesystem::path& file) {
  const std::string what = "'" + file.string() + "': " + key;
  const auto found = json.is_object() ? json.find(key) : json.end();
  if (!json.is_object() || found == json.end() || !found->is_array())
    throw InputError(what + " is missing; it must be a list of points [x, y, z] in mm");
  Points points(static_cast<Index>(found->size()), 3);
  for (std::size_t i = 0; i < found->size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const nlohmann::json& row = (*found)[i];
      if (!row.is_array() || row.size() != 3 || !row[axis].is_number())
        throw InputError(what + " has no point [x, y, z] in place " + std::to_string(i + 1) +
                         "; give three numbers in mm");
      points(static_cast<Index>(i), static_cast<Index>(axis)) = row[axis].get<double>();
    }
  if (!points.allFinite()) throw InputError(what + " holds a number that is not finite; mend it");
  return points;
}

TrialTargets fromTruthFile(const std::filesystem::path& file, CommandRun& run) {
  const nlohmann::json json = readJsonFile(file);
  run.remember(file);
  TrialTargets targets{pointsOf(json, "targets_preop_mm", file), pointsOf(json, "targets_scanner_mm", file)};
  if (targets.preop.rows() != targets.scan.rows() || targets.preop.rows() == 0)
    throw InputError("'" + file.string() + "' holds " + std::to_string(targets.preop.rows()) +
                     " targets and " + std::to_string(targets.scan.rows()) +
                     " true positions; give as many of both, at least one");
  return targets;
}

}  // namespace

void declareTrialFiles(Syntax& syntax, const std::string& group) {
  using enum ArgumentKind;
  syntax.add({.name = "preop",
              .kind = Surface,
              .label = "Pre-operative surface",
              .help = "LPS mm, with a Patch array for methods that use patches.",
              .required = true,
              .group = group});
  syntax.add({.name = "scan",
              .kind = Surface,
              .label = "Scan",
              .help = "Surface or point cloud in the scanner's frame, mm.",
              .required = true,
              .group = group});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help =
                  "Receives trials.csv, summary.json, report.html and histograms. A run that is stopped "
                  "(Ctrl-C) leaves trials.partial.csv there, and the same command goes on where it stood.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "targets",
              .kind = Points,
              .label = "Targets",
              .help = "Points inside the liver, pre-op LPS mm: success is then by target error.",
              .group = group});
  syntax.add({.name = "truth-targets",
              .kind = Points,
              .label = "True targets",
              .help = "Where the targets truly are, scan mm.",
              .group = group});
  syntax.add({.name = "truth",
              .kind = File,
              .label = "Truth",
              .help = "In place of both: a JSON file with the lists targets_preop_mm and targets_scanner_mm.",
              .group = group});
  syntax.add({.name = "gold",
              .kind = Transform,
              .label = "Gold standard",
              .help =
                  "Transform that maps pre-op mm to scan mm. Without it the best rigid fit of the targets, "
                  "and without three targets the default registration.",
              .group = group});
}

void checkTargetArguments(const ParsedArguments& arguments) {
  if (arguments.has("targets") != arguments.has("truth-targets"))
    throw InputError("--targets and --truth-targets belong together; give both or none");
  if (arguments.has("targets") && arguments.has("truth"))
    throw InputError("--truth holds targets and true targets; leave it or the other two out");
}

TrialTargets readTrialTargets(const ParsedArguments& arguments, CommandRun& run) {
  if (arguments.has("truth")) return fromTruthFile(arguments.path("truth"), run);
  if (!arguments.has("targets")) return {Points(0, 3), Points(0, 3)};
  const Landmarks targets = run.landmarks(arguments.path("targets")),
                  truth = run.landmarks(arguments.path("truth-targets"));
  const PairedTargets paired = pairTargets(targets, truth);
  return {paired.preop, paired.scan};
}

TrialScale readTrialScale(const std::string& text, CommandRun& run) {
  if (text == "small") return kSmallScale;
  if (text == "large") return kLargeScale;
  if (!std::filesystem::exists(text))
    throw InputError("--scale is '" + text +
                     "'; choose small, large or a JSON file {\"rotationDeg\": 30, \"translationMm\": 20}");
  run.remember(text);
  return settingsFromJson<TrialScale>(readJsonFile(text));
}

}  // namespace falciform::commandline
