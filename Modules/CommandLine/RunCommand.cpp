#include "Modules/CommandLine/CaseResults.h"
#include "Modules/CommandLine/CaseUpdate.h"
#include "Modules/CommandLine/Commands.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  syntax.add({.name = "CASE",
              .kind = ArgumentKind::Folder,
              .label = "Case",
              .help = "Folder with a case.json, or the file itself.",
              .required = true,
              .positional = true,
              .group = "Files"});
  syntax.add(
      {.name = "out",
       .kind = ArgumentKind::Folder,
       .label = "Result folder",
       .help = "Receives surfaces, transforms, tables, pictures, report.html, run.json, and update/ with the "
               "liver as it is now.",
       .required = true,
       .output = true,
       .group = "Files"});
  declareCaseSettings(syntax);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out");
  for (const auto& file : caseResultFiles(folder)) run.outputs.announce(file);
  const std::filesystem::path given = arguments.path("CASE");
  const CaseDescription description = readCaseDescription(given);
  CaseSettings settings = caseSettings(description, arguments);
  announceCaseUpdate(description, settings, folder, run);
  run.remember(std::filesystem::is_directory(given) ? given / "case.json" : given);
  const CaseOutcome outcome = runCase(description, settings, run, run.progress.part(0, 0.7));
  writeCaseResults(outcome, description, settings, folder, run, run.progress.part(0.7, 1));
  tellCaseResults(outcome, folder, run);
}

}  // namespace

Command runCommand() {
  return {"run", "Run case",
          "Carries a case from its label map to registration, distance map, model update, warped CT, "
          "pictures and "
          "a report.",
          declare, execute};
}

}  // namespace falciform::commandline
