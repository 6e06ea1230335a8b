#include "Modules/CommandLine/CohortFigures.h"
#include "Modules/CommandLine/CohortReport.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/SvgHeatmap.h"

namespace falciform::commandline {

namespace {

constexpr const char* kFiles[] = {"groups.csv",      "leave_one_out.csv", "likeness.csv", "correlation.csv",
                                  "correlation.svg", "report.html",       "cohort.json"};

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
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
              .help = "Columns case and group, .csv; an empty group is a procedure of its own.",
              .required = true,
              .group = group});
  syntax.add({.name = "out",
              .kind = Folder,
              .label = "Result folder",
              .help = "Receives groups.csv, leave_one_out.csv, likeness.csv, correlation.csv, "
                      "correlation.svg, report.html and cohort.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.addSettings(PermutationSettings{}, "Permutation test");
  syntax.addResult({"in_group_mean", "Mean correlation in groups", ""});
  syntax.addResult({"out_group_mean", "Mean correlation between groups", ""});
  syntax.addResult({"p_permutation", "p of the permutation test, one-sided", ""});
}

void tell(const std::string& name, const GroupComparison& c, int seed, CommandRun& run) {
  if (c.inGroup.count == 0) {
    run.say(name + ": one case, nothing to compare");
    return;
  }
  run.say(name + ": in-group " + meanAndSd(c.inGroup) + " (" + std::to_string(c.inGroup.count) +
          (c.inGroup.count == 1 ? " pair" : " pairs") + "), out-group " + meanAndSd(c.outGroup) + " (" +
          std::to_string(c.outGroup.count) + "); p: permutation " + pText(c.permutation.pGreater) +
          " one-sided, " + pText(c.permutation.pTwoSided) + " two-sided (" +
          arrangementsText(c.permutation, seed) + "), Welch " + pText(c.welch.p) + ", pooled " +
          pText(c.pooled.p));
}

CohortInput read(const ParsedArguments& arguments, CommandRun& run) {
  if (arguments.has("matrix") == arguments.has("maps"))
    throw InputError(arguments.has("matrix") ? "--matrix and --maps are both given; give one of them"
                                             : "neither --matrix nor --maps is given; give one of them");
  CohortInput input = arguments.has("matrix") ? readCorrelationMatrix(arguments.path("matrix"), run)
                                              : readCohortMaps(arguments.path("maps"), run);
  readCohortGroups(arguments.path("groups"), input.cohort, run);
  return input;
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out");
  for (const char* name : kFiles) run.outputs.announce(folder / name);
  const auto settings = arguments.settings(PermutationSettings{});
  run.settings["cohort"] = settingsToJson(settings);

  run.progress.report(0, "Reading");
  const CohortInput input = read(arguments, run);
  const CohortAnalysis analysis = analyseCohort(input.cohort, settings, run.progress.part(0.1, 0.95));
  run.warn(analysis.warnings);
  run.figures = cohortFigures(input, analysis);

  run.progress.report(0.95, "Writing");
  const auto text = [&](const char* name, const std::string& content) {
    writeTextFile(run.outputs.staged(folder / name), Overwrite::Replace, content);
  };
  const std::string svg = correlationSvg(input.cohort);
  text("groups.csv", groupsCsv(input.cohort, analysis));
  text("leave_one_out.csv", leaveOneOutCsv(input.cohort, analysis));
  text("likeness.csv", likenessCsv(input.cohort, analysis));
  text("correlation.csv", correlationCsv(input.cohort));
  text("correlation.svg", svg);
  text("report.html", cohortReportHtml(input, analysis, settings, svg, run.provenance));
  run.writeSidecar(folder / "cohort.json");

  if (input.vertices > 0)
    run.say("all cases cover " + std::to_string(input.overlap) + " of " + std::to_string(input.vertices) +
            " vertices");
  for (std::size_t g = 0; g < input.cohort.groups.size(); ++g)
    tell("group " + input.cohort.groups[g], analysis.groups[g], settings.seed, run);
  tell(kAllGroups, analysis.all, settings.seed, run);
  run.say("report: " + (folder / "report.html").string());
}

}  // namespace

Command cohortCommand() {
  return {"cohort", "Cohort statistics",
          "Says whether cases of one procedure deform more alike than others: correlations, t tests, exact "
          "permutation tests, each case left out.",
          declare, execute};
}

}  // namespace falciform::commandline
