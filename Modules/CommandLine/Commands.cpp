#include "Modules/CommandLine/Commands.h"

namespace falciform::commandline {

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      segmentCommand(),    importCommand(),    scanCommand(),       smoothCommand(),    suggestCommand(),
      patchesCommand(),    registerCommand(),  distanceCommand(),   normaliseCommand(), cohortCommand(),
      runCommand(),        demoCommand(),      synthesiseCommand(), trialsCommand(),    meshCommand(),
      atlasBuildCommand(), atlasInfoCommand(), updateCommand(),     locateCommand(),    fiducialsCommand(),
      infoCommand()};
  return all;
}

Syntax syntaxOf(const Command& command) {
  Syntax syntax(command.name, command.title, command.summary);
  command.declare(syntax);
  addGlobalArguments(syntax);
  return syntax;
}

}  // namespace falciform::commandline
