#include <chrono>

#include "Logic/Core/Parallel.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/Trials/TrialBasins.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/KeptTrials.h"
#include "Modules/CommandLine/TrialFigures.h"
#include "Modules/CommandLine/TrialInputs.h"
#include "Modules/CommandLine/TrialReport.h"
#include "Modules/CommandLine/TrialRows.h"
#include "Modules/CommandLine/TrialTables.h"

namespace falciform::commandline {

namespace {

constexpr const char* kFiles[] = {"trials.csv", "report.html", "histogram_rms.svg",
                                  "histogram_target_error.svg", "summary.json"};

std::string methodHelp() {
  const std::vector<std::string> presets = registrationPresets();
  const std::vector<std::string_view> names(presets.begin(), presets.end());
  return "With commas between: [preset/]method[:patch+patch...], as in icp,picp:1+2,thesis-phantom/picp:1. "
         "Methods: " +
         listOfNames(enumNames(RegistrationMethod{})) + "; presets: " + listOfNames(names) +
         ". Without patches all that both sides have are used.";
}

void declare(Syntax& syntax) {
  declareTrialFiles(syntax, "Files");
  syntax.add({.name = "methods",
              .kind = ArgumentKind::Text,
              .label = "Methods",
              .help = methodHelp(),
              .fallback = "icp,picp:1,picp:1+2",
              .group = "Trials"});
  syntax.add({.name = "scale",
              .kind = ArgumentKind::Text,
              .label = "Scale",
              .help =
                  "small (45 deg, 50 mm an axis), large (180 deg, 200 mm), or a JSON file {\"rotationDeg\": "
                  "30, \"translationMm\": 20}.",
              .fallback = "large",
              .group = "Trials"});
  syntax.addSettings(TrialSettings{}, "Trials");
  syntax.addSettings(ScanVariation{}, "Variation of the scan");
}

/// What the trials rest on: if any of it changes, those that were done no longer count.
nlohmann::json basisOf(const TrialOutcome& outcome, const CommandRun& run) {
  const nlohmann::json settings = trialSettingsJson(outcome);
  nlohmann::json trials = settings.at("trials");
  for (const char* free : {"count", "atOnce", "basinMm", "goldWithinMm"}) trials.erase(free);
  nlohmann::json inputs = nlohmann::json::array();
  for (const auto& [name, digest] : run.provenance.inputSha256) inputs.push_back({name, digest});
  return {{"version", toJson(run.provenance).at("version")},
          {"input file", inputs},
          {"seed", run.provenance.seed},
          {"scale", settings.at("scale")},
          {"trial setting", trials},
          {"variation of the scan", settings.at("scan_variation")},
          {"method or setting of it", settings.at("methods")},
          {"gold standard", matrixToJson(outcome.gold.scanFromPreop)}};
}

std::vector<TrialRecord> runKept(const TrialOutcome& outcome, const TrialCase& data,
                                 const std::filesystem::path& folder, bool anew, CommandRun& run) {
  KeptTrials kept(folder, basisOf(outcome, run), outcome.methods);
  const std::vector<TrialRecord> earlier = kept.earlier(outcome.settings.count, anew);
  const std::size_t all = static_cast<std::size_t>(outcome.settings.count) * outcome.methods.size();
  if (!earlier.empty())
    run.say("continued: " + std::to_string(earlier.size()) + " of " + std::to_string(all) +
            " registrations were done before");
  run.outputs.supersede(kept.file());
  try {
    return runTrials(
        data, outcome.methods, outcome.scale, outcome.settings, earlier,
        [&](const TrialRecord& record) { kept.keep(record); }, run.progress.part(0.05, 0.98));
  } catch (const Cancelled&) {
    if (kept.size() == 0) throw;
    throw Interrupted("cancelled; " + std::to_string(kept.size()) + " registrations are kept in '" +
                      kept.file().string() + "', and the same command goes on from there");
  }
}

void tell(const TrialOutcome& outcome, CommandRun& run) {
  const bool targets = outcome.targets > 0;
  run.say("gold standard: " + outcome.gold.source + "; RMS " + fixed(outcome.gold.rmsMm, 2) + " mm" +
          (targets ? ", target error " + fixed(outcome.gold.targetErrorMm, 2) + " mm" : ""));
  for (std::size_t i = 0; i < outcome.methods.size(); ++i) {
    const TrialSummary& s = outcome.summaries[i];
    const SampleStatistics& error = targets ? s.targetErrorOfSuccessesMm : s.rmsOfSuccessesMm;
    run.say(outcome.methods[i].name + ": " + std::to_string(s.successes) + " of " + std::to_string(s.trials) +
            " succeed (95 %: " + fixed(100 * s.success.low, 2) + " to " + fixed(100 * s.success.high, 2) +
            " %); " + (targets ? "target error" : "RMS") + " of successes " + fixed(error.mean, 2) + " mm; " +
            std::to_string(s.basins) + (s.basins == 1 ? " pose" : " poses") + "; flagged " +
            std::to_string(s.failuresFlagged) + " of " + std::to_string(s.trials - s.successes) +
            " failures, " + std::to_string(s.successesFlagged) + " of " + std::to_string(s.successes) +
            " successes; median " + fixed(s.seconds.median, 3) + " s");
  }
}

void write(const TrialOutcome& outcome, const std::filesystem::path& folder, CommandRun& run) {
  const auto text = [&](const char* name, const std::string& content) {
    writeTextFile(run.outputs.staged(folder / name), Overwrite::Replace, content);
  };
  const TrialHistograms histograms = trialHistograms(outcome);
  text("trials.csv", trialsCsv(outcome));
  text("histogram_rms.svg", histograms.rms);
  if (!histograms.targetError.empty()) text("histogram_target_error.svg", histograms.targetError);
  text("report.html", trialReportHtml(outcome, histograms, run.provenance));
  run.settings = trialSettingsJson(outcome);
  run.figures = trialFigures(outcome);
  run.frames["gold_standard.scan_from_preop"] = "maps pre-op LPS mm to scan mm";
  run.writeSidecar(folder / "summary.json");
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out");
  for (const char* name : kFiles) run.outputs.announce(folder / name);
  checkTargetArguments(arguments);
  TrialOutcome outcome;
  outcome.methods = parseTrialMethods(arguments.text("methods"));
  outcome.settings = arguments.settings(TrialSettings{});
  outcome.settings.variation = arguments.settings(ScanVariation{});
  outcome.scale = readTrialScale(arguments.text("scale"), run);
  outcome.scaleName = std::filesystem::path(arguments.text("scale")).filename().string();
  outcome.threads = threads();

  run.progress.report(0, "Reading");
  const Surface preopSurface = run.mesh(arguments.path("preop")), scan = run.surface(arguments.path("scan"));
  const TrialTargets targets = readTrialTargets(arguments, run);
  std::optional<Isometry3d> given;
  if (arguments.has("gold")) given = run.transform(arguments.path("gold"));
  const auto began = std::chrono::steady_clock::now();
  const PreparedPreop preop(preopSurface);
  outcome.preparationSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  outcome.targets = targets.preop.rows();
  outcome.preopPoints = preopSurface.size();
  outcome.scanPoints = scan.size();
  outcome.optimalRigidMm =
      targets.preop.rows() < 3
          ? std::numeric_limits<double>::quiet_NaN()
          : targetErrors(targets.preop, targets.scan, fitRigid(targets.preop, targets.scan)).mean();
  run.progress.report(0.01, "Gold standard");
  outcome.gold = goldStandard(preop, scan, targets, given, run.progress.part(0.01, 0.05));

  outcome.records =
      runKept(outcome, trialCase(preop, scan, targets, outcome.gold), folder, arguments.has("force"), run);
  outcome.basins =
      trialBasins(outcome.records, outermostPoints(preopSurface.points), outcome.settings.basinMm);
  for (std::size_t i = 0; i < outcome.methods.size(); ++i)
    outcome.summaries.push_back(
        summarise(outcome.records, outcome.basins, static_cast<int>(i), outcome.settings));
  run.progress.report(0.98, "Writing");
  write(outcome, folder, run);
  tell(outcome, run);
  if (const std::string note = alikeNote(outcome); !note.empty()) run.say(note);
  run.say("report: " + (folder / "report.html").string());
}

}  // namespace

Command trialsCommand() {
  return {"trials", "Registration trials",
          "Perturbs a scan many times and registers it anew by several methods: success, error, time.",
          declare, execute};
}

}  // namespace falciform::commandline
