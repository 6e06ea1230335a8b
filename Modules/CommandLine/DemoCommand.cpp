#include "Modules/CommandLine/BuiltInCase.h"
#include "Modules/CommandLine/CaseResults.h"
#include "Modules/CommandLine/CaseUpdate.h"
#include "Modules/CommandLine/Commands.h"

namespace falciform::commandline {

namespace {

constexpr double kPackingMm = 20;

void declare(Syntax& syntax) {
  syntax.add({.name = "out",
              .kind = ArgumentKind::Folder,
              .label = "Folder",
              .help = "Receives case/ and results/.",
              .fallback = "falciform-demo",
              .output = true,
              .group = "Files"});
  declareCaseSettings(syntax);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path folder = arguments.path("out"), caseFolder = folder / "case",
                              results = folder / "results";
  for (const auto& file : builtInCaseFiles(caseFolder, {})) run.outputs.announce(file);
  for (const auto& file : caseResultFiles(results)) run.outputs.announce(file);
  BuiltInCaseSettings made;
  // Bent as an operation bends it, on other elements of another surface than the update's, which are made
  // from the label map: what the update finds is not what it was given.
  made.packing.packingMm = kPackingMm;
  made.liver.seed = made.deformation.seed = made.scanner.seed = made.touch.seed = arguments.integer("seed");
  writeBuiltInCase(makeBuiltInCase(made, run.progress.part(0, 0.3)), caseFolder, run.outputs);

  // The case is read back from its files: the demo walks the road of any case. They still lie in the hidden
  // folder.
  const CaseDescription description = readCaseDescription(run.outputs.staged(caseFolder / "case.json"));
  CaseSettings settings = caseSettings(description, arguments);
  announceCaseUpdate(description, settings, results, run);
  const CaseOutcome outcome = runCase(description, settings, run, run.progress.part(0.3, 0.75));
  writeCaseResults(outcome, description, settings, results, run, run.progress.part(0.75, 1));
  run.say("case:     " + caseFolder.string());
  tellCaseResults(outcome, results, run);
}

}  // namespace

Command demoCommand() {
  return {"demo", "Demonstration", "Makes the built-in case and runs it, pictures and report included.",
          declare, execute};
}

}  // namespace falciform::commandline
