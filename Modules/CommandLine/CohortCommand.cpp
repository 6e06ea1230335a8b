#include "Logic/IO/SurfaceFiles.h"
#include "Modules/CommandLine/CohortFigures.h"
#include "Modules/CommandLine/CohortPictures.h"
#include "Modules/CommandLine/CohortReport.h"
#include "Modules/CommandLine/CohortStatistics.h"
#include "Modules/CommandLine/CohortTables.h"
#include "Modules/CommandLine/Commands.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "COHORT",
              .kind = File,
              .label = "Cohort",
              .help =
                  "The whole chain from the cases themselves: .json that names the cases, their groups and "
                  "the target liver. Instead of it --matrix or --maps, with --groups.",
              .positional = true,
              .group = group});
  syntax.add({.name = "matrix",
              .kind = File,
              .label = "Correlation matrix",
              .help =
                  "Correlation of each two cases, .csv: head case,NAME,NAME,... and a row a case; one half "
                  "is enough.",
              .group = group});
  syntax.add({.name = "maps",
              .kind = File,
              .label = "Maps",
              .help =
                  "Instead of a matrix: values on the vertices of one target liver, .csv: a column a case, "
                  "a row a vertex, empty or nan where a case does not cover it.",
              .group = group});
  syntax.add({.name = "groups",
              .kind = File,
              .label = "Groups",
              .help =
                  "Of --matrix and --maps: columns case and group, .csv; an empty group is a procedure of "
                  "its own.",
              .group = group});
  syntax.add(
      {.name = "out",
       .kind = Folder,
       .label = "Result folder",
       .help = "Receives groups.csv, leave_one_out.csv, likeness.csv, correlation.csv, "
               "correlation.svg, report.html and cohort.json; of a whole cohort these for each metric, and "
               "maps, pictures and tables.",
       .required = true,
       .output = true,
       .group = group});
  syntax.addSettings(PermutationSettings{}, "Permutation test");
  syntax.addResult({"in_group_mean", "Mean correlation in groups", ""});
  syntax.addResult({"out_group_mean", "Mean correlation between groups", ""});
  syntax.addResult({"p_permutation", "p of the permutation test, one-sided", ""});
}

CohortInput read(const ParsedArguments& arguments, CommandRun& run) {
  if (!arguments.has("matrix") && !arguments.has("maps"))
    throw InputError("neither --matrix nor --maps nor a cohort is given; give one of them");
  if (arguments.has("matrix") && arguments.has("maps"))
    throw InputError("--matrix and --maps are both given; give one of them");
  if (!arguments.has("groups")) throw InputError("--groups is missing (Groups); see falciform cohort --help");
  CohortInput input = arguments.has("matrix") ? readCorrelationMatrix(arguments.path("matrix"), run)
                                              : readCohortMaps(arguments.path("maps"), run);
  readCohortGroups(arguments.path("groups"), input.cohort, run);
  return input;
}

/// From correlations or maps that are there already.
void compare(const ParsedArguments& arguments, const PermutationSettings& settings, CommandRun& run) {
  const fs::path folder = arguments.path("out");
  for (const std::string& name : cohortStatisticsFiles()) run.outputs.announce(folder / name);
  run.outputs.announce(folder / "report.html");
  run.outputs.announce(folder / "cohort.json");
  run.progress.report(0, "Reading");
  const CohortInput input = read(arguments, run);
  const CohortAnalysis analysis = analyseCohort(input.cohort, settings, run.progress.part(0.1, 0.95));
  run.warn(analysis.warnings);
  run.figures = cohortFigures(input, analysis);

  run.progress.report(0.95, "Writing");
  const std::string svg = writeCohortStatistics(input, analysis, folder, run);
  writeTextFile(run.outputs.staged(folder / "report.html"), Overwrite::Replace,
                cohortReportHtml(input, analysis, settings, svg, run.provenance));
  run.writeSidecar(folder / "cohort.json");
  if (input.vertices > 0)
    run.say("all cases cover " + std::to_string(input.overlap) + " of " + std::to_string(input.vertices) +
            " vertices");
  tellCohortStatistics(input, analysis, settings.seed, run);
}

/// All that the chain may write: the true metric's only where the cases have their truth.
void announceChain(const CohortFile& cohort, const fs::path& folder, CommandRun& run) {
  bool truth = true;
  std::vector<std::string> names;
  for (const CohortMember& member : cohort.members) {
    truth = truth && !member.truth.empty();
    names.push_back(member.name);
    run.outputs.announce(folder / "cases" / (member.name + ".vtp"));
  }
  for (const CohortMetricInfo& metric : kCohortMetrics) {
    if (metric.metric == CohortMetric::TrueDisplacement && !truth) continue;
    for (const std::string& name : cohortStatisticsFiles())
      run.outputs.announce(folder / metric.folder / name);
    run.outputs.announce(folder / metric.folder / "maps.csv");
  }
  for (const std::string& name : cohortPictureNames(names)) run.outputs.announce(folder / "pictures" / name);
  for (const char* name :
       {"target.vtp", "cases.csv", "surface_errors.csv", "tables.md", "report.html", "cohort.json"})
    run.outputs.announce(folder / name);
}

void writeSurfaces(const CohortOutcome& outcome, const fs::path& folder, CommandRun& run) {
  falciform::Surface target = *outcome.cases[outcome.target].own;
  target.arrays.clear();
  VectorXd overlap = VectorXd::Zero(target.size());
  overlap(outcome.overlap).setOnes();
  target.arrays["overlap"] = overlap;
  for (const MeasuredCase& measured : outcome.cases) {
    writeSurface(run.outputs.staged(folder / "cases" / (measured.name + ".vtp")), *measured.own,
                 Overwrite::Replace);
    for (std::size_t k = 0; k < outcome.metrics.size(); ++k)
      target.arrays[measured.name + "_" + kCohortMetrics[k].array] =
          measured.carried.values.col(static_cast<Index>(k));
  }
  writeSurface(run.outputs.staged(folder / "target.vtp"), target, Overwrite::Replace);
  run.frames["cases/*.vtp"] = "each patient's LPS, mm: the pre-op liver with its maps";
  run.frames["target.vtp"] = "the target patient's LPS, mm: all cases' maps, and where all cover it";
}

/// From the cases themselves.
void runChain(const ParsedArguments& arguments, const PermutationSettings& settings, CommandRun& run) {
  for (const char* other : {"matrix", "maps", "groups"})
    if (arguments.has(other))
      throw InputError("--" + std::string(other) +
                       " has no meaning beside a cohort; leave one of the two out");
  const fs::path folder = arguments.path("out"), file = arguments.path("COHORT");
  const CohortFile cohort = readCohortFile(file);
  announceChain(cohort, folder, run);
  run.remember(file);
  const CohortOutcome outcome = runCohort(cohort, settings, run, run.progress.part(0, 0.85));

  run.progress.report(0.85, "Writing");
  const auto text = [&](const fs::path& name, const std::string& content) {
    writeTextFile(run.outputs.staged(folder / name), Overwrite::Replace, content);
  };
  std::vector<std::string> matrices;
  for (std::size_t k = 0; k < outcome.metrics.size(); ++k) {
    const MetricResult& metric = outcome.metrics[k];
    matrices.push_back(
        writeCohortStatistics(metric.input, metric.analysis, folder / metric.info.folder, run));
    text(fs::path(metric.info.folder) / "maps.csv", mapsCsv(outcome, k));
    run.figures[metric.info.folder] = cohortFigures(metric.input, metric.analysis);
  }
  for (const char* key : {"in_group_mean", "out_group_mean", "p_permutation"})
    run.figures[key] = run.figures[kCohortMetrics[0].folder][key];
  text("cases.csv", casesCsv(outcome));
  text("surface_errors.csv", surfaceErrorsCsv(outcome));
  text("tables.md", tablesMarkdown(outcome));
  writeSurfaces(outcome, folder, run);
  const fs::path pictures = run.outputs.staged(folder / "pictures" / "overlap.png").parent_path();
  const std::vector<PictureFile> drawn = saveCohortPictures(outcome, pictures, run.progress.part(0.88, 0.98));
  text("report.html", chainReportHtml(cohort, outcome, settings, matrices, drawn, run.provenance));
  run.writeSidecar(folder / "cohort.json");

  run.say("all cases cover " + std::to_string(outcome.overlap.size()) + " of " +
          std::to_string(outcome.cases[outcome.target].own->size()) + " vertices of the target liver");
  for (const MetricResult& metric : outcome.metrics) {
    run.say(std::string(metric.info.title) + ":");
    tellCohortStatistics(metric.input, metric.analysis, settings.seed, run);
  }
  run.say("tables: " + (folder / "tables.md").string());
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const auto settings = arguments.settings(PermutationSettings{});
  run.settings["cohort"] = settingsToJson(settings);
  (arguments.has("COHORT") ? runChain : compare)(arguments, settings, run);
  run.say("report: " + (arguments.path("out") / "report.html").string());
}

}  // namespace

Command cohortCommand() {
  return {"cohort", "Cohort statistics",
          "Measures each case, brings the maps onto one liver and says whether cases of one procedure deform "
          "more alike than others: correlations, t tests, exact permutation tests, each case left out.",
          declare, execute};
}

}  // namespace falciform::commandline
