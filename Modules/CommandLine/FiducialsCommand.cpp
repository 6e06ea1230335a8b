#include <cmath>

#include "Logic/Core/LandmarkPairs.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/Registration/PointRegistration.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  for (const auto& [name, label, help] :
       {std::tuple("from", "Fiducials, pre-op", "At least three points, mm: .mrk.json or .fcsv."),
        std::tuple("to", "Fiducials, scan",
                   "The same points where the scanner or tracker saw them; paired by name where all names "
                   "agree, else by order.")})
    syntax.add(
        {.name = name, .kind = Points, .label = label, .help = help, .required = true, .group = group});
  syntax.add({.name = "targets",
              .kind = Points,
              .label = "Targets, pre-op",
              .help =
                  "Points that are no fiducials: their error is expected from the fiducials, and measured "
                  "with --truth-targets.",
              .group = group});
  syntax.add({.name = "truth-targets",
              .kind = Points,
              .label = "Targets, scan",
              .help = "Where the targets truly are.",
              .group = group});
  syntax.add({.name = "out",
              .kind = Transform,
              .label = "Transform",
              .help = "Maps --from mm to --to mm: .tfm, .txt or .json; its sidecar is written beside it as "
                      "FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.addResult({"fre_mm", "FRE", "mm"});
  syntax.addResult({"fle_estimate_mm", "FLE estimate", "mm"});
}

void addTargets(const ParsedArguments& arguments, const falciform::Points& fiducials,
                const PointRegistrationResult& fit, CommandRun& run) {
  const Landmarks targets = run.landmarks(arguments.path("targets"));
  if (targets.points.empty()) throw InputError("--targets holds no point; give targets or leave it out");
  VectorXd measured;
  if (arguments.has("truth-targets")) {
    const PairedTargets paired = pairTargets(targets, run.landmarks(arguments.path("truth-targets")));
    measured = targetErrors(paired.preop, paired.scan, fit.targetFromSource);
  }
  double expected = 0;
  for (std::size_t t = 0; t < targets.points.size(); ++t) {
    const Landmark& target = targets.points[t];
    const double tre = predictedTre(fiducials, fit.fleEstimateMm, target.position);
    nlohmann::json row{{"name", target.name}, {"expected_tre_mm", tre}};
    if (measured.size() > 0) row["tre_mm"] = measured[static_cast<Index>(t)];
    run.figures["targets"].push_back(row);
    expected += tre * tre / static_cast<double>(targets.points.size());
  }
  run.figures["expected_tre_rms_mm"] = std::sqrt(expected);
  std::string line = "targets: expected error " + fixed(std::sqrt(expected), 3) + " mm RMS";
  if (measured.size() > 0) {
    const double rms = std::sqrt(measured.squaredNorm() / static_cast<double>(measured.size()));
    run.figures["tre_rms_mm"] = rms;
    run.figures["tre_mean_mm"] = measured.mean();
    run.figures["tre_largest_mm"] = measured.maxCoeff();
    line += ", measured " + fixed(rms, 3) + " mm RMS, mean " + fixed(measured.mean(), 3) + " mm, largest " +
            fixed(measured.maxCoeff(), 3) + " mm";
  }
  run.say(line);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path out = arguments.path("out");
  run.outputs.announce(out);
  run.outputs.announce(sidecarOf(out));
  if (arguments.has("truth-targets") && !arguments.has("targets"))
    throw InputError("--truth-targets without --targets says nothing; give both");
  const Landmarks from = run.landmarks(arguments.path("from")), to = run.landmarks(arguments.path("to"));
  const PointRegistrationResult fit = registerPoints(from, to);
  run.warn(fit.warnings);
  run.frames = {
      {out.filename().string(), "maps " + from.frame + " mm of --from to " + to.frame + " mm of --to"}};
  run.figures = {
      {"fre_mm", fit.freMm}, {"fle_estimate_mm", fit.fleEstimateMm}, {"fiducials", nlohmann::json::array()}};
  for (std::size_t i = 0; i < from.points.size(); ++i)
    run.figures["fiducials"].push_back(
        {{"name", from.points[i].name}, {"fre_mm", fit.freByPointMm[static_cast<Index>(i)]}});
  run.say("FRE " + fixed(fit.freMm, 3) + " mm over " + std::to_string(from.points.size()) +
          " fiducials, FLE estimate " + fixed(fit.fleEstimateMm, 3) + " mm");
  for (const auto& row : run.figures["fiducials"])
    run.say("  " + row["name"].get<std::string>() + "  " + fixed(row["fre_mm"].get<double>(), 3) + " mm");
  if (arguments.has("targets")) addTargets(arguments, positionsOf(from), fit, run);
  writeTransform(run.outputs.staged(out), fit.targetFromSource,
                 "point-based registration: maps --from mm to --to mm", Overwrite::Replace);
  run.writeSidecar(sidecarOf(out));
}

}  // namespace

Command fiducialsCommand() {
  return {"fiducials", "Fiducial registration",
          "Registers points to points and says how well they fit and what that promises at targets.", declare,
          execute};
}

}  // namespace falciform::commandline
