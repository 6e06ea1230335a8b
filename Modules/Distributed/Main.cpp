#include <exception>
#include <iostream>

#include "Logic/Atlas/KeptSolves.h"
#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Modules/CommandLine/BuildShare.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/DesignInput.h"
#include "Modules/CommandLine/HelpText.h"
#include "Modules/CommandLine/LiverInput.h"
#include "Modules/Distributed/DistributedSolves.h"
#include "Version.h"

namespace falciform::distributed {

using namespace commandline;

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  declareLiverInput(syntax, "Files");
  syntax.add({.name = "out",
              .kind = File,
              .label = "Atlas",
              .help = "Atlas that falciform atlas build will write, .h5; the solves are kept in FILE.part.",
              .required = true,
              .output = true,
              .group = "Files"});
  const IterationPlan plan;
  syntax.add({.name = "tolerance",
              .kind = Number,
              .label = "Tolerance",
              .help = "Residual, as a share of the load, at which a solve ends.",
              .fallback = numberText(plan.relativeTolerance),
              .min = 1e-14,
              .max = 1e-2,
              .group = "Iteration"});
  syntax.add({.name = "max-iterations",
              .kind = Integer,
              .label = "Iterations",
              .help = "A solve that needs more is given up.",
              .fallback = std::to_string(plan.maxIterations),
              .min = 1,
              .max = 1000000,
              .group = "Iteration"});
  syntax.add(
      {.name = "shard",
       .kind = Text,
       .label = "Part of the work",
       .help = "Do part K/N of the solves (K from 0), beside other calls of mpirun with the same arguments.",
       .fallback = "0/1",
       .group = "Files"});
  syntax.add({.name = "DESIGN",
              .kind = Text,
              .label = "Design",
              .help = "JSON file that says which deformations, or a preset: " + atlasPresetsText() + ".",
              .required = true,
              .positional = true,
              .group = "Files"});
}

Syntax syntax() {
  return syntaxOf(
      {"distributed", "Solves over ranks",
       "Solves an atlas's design on one mesh over MPI ranks and keeps the solves for falciform atlas "
       "build. Call it as mpirun -n RANKS falciform-distributed DESIGN ...",
       declare, nullptr});
}

AtlasJob readJob(const ParsedArguments& arguments, CommandRun& run) {
  if (arguments.path("out").extension() != ".h5")
    throw InputError("--out is '" + arguments.text("out") + "'; an atlas is written as .h5");
  if (!arguments.has("mesh"))
    throw InputError("--mesh is not given; make one with falciform mesh, so that all ranks have the same");
  const AtlasDesign design = readDesign(arguments.text("DESIGN"), run);
  const LiverInput liver = readLiverInput(arguments, run, {});
  const SupportSites sites = findSupportSites(liver.surface, liver.mesh, boundaryFaces(liver.mesh));
  run.warn(sites.warnings);
  return prepareAtlas(liver.mesh, sites, design);
}

void execute(const Ranks& ranks, const ParsedArguments& arguments) {
  setThreads(arguments.integer("threads"));
  if (arguments.integer("threads") == 0) shareThreads();
  CommandRun run;
  run.quiet = !ranks.first() || arguments.has("quiet");
  run.provenance.seed = static_cast<std::uint64_t>(arguments.integer("seed"));
  std::optional<AtlasJob> job;
  ranks.together([&] { job = readJob(arguments, run); });
  std::optional<KeptSolves> kept;
  std::vector<int> missing;
  ranks.together([&] {
    kept.emplace(arguments.text("out") + ".part", basisOf(*job, kVersion), *job);
    if (ranks.first()) kept->open(arguments.has("force"));
  });
  const std::vector<int> mine =
      buildShare(arguments.text("shard")).of(static_cast<int>(job->solves.batches.size()));
  std::vector<char> there(mine.size(), 1);
  ranks.together([&] {
    for (std::size_t k = 0; k < mine.size() && ranks.first(); ++k) there[k] = kept->has(mine[k]);
  });
  // The first rank says what is missing: others may see the folder late.
  for (std::size_t k = 0; k < mine.size(); ++k)
    if (ranks.sum(there[k]) < ranks.size()) missing.push_back(mine[k]);
  const IterationPlan plan{parseNumber("--tolerance", arguments.text("tolerance")),
                           arguments.integer("max-iterations")};
  solveTogether(
      ranks, *job, missing, plan,
      [&](int batch, const std::vector<Points>& fields) { kept->keep(batch, fields); },
      [&](const std::string& line) {
        if (!run.quiet) std::cout << line << std::endl;
      });
  run.say(std::to_string(kept->count()) + " of " + std::to_string(job->solves.solves.size()) +
          " solves are kept in '" + kept->folder().string() +
          "'; falciform atlas build with the same --preop, --mesh, --seed and --out goes on from there");
  if (ranks.first()) run.print();
}

int guarded(const Ranks& ranks, const std::vector<std::string>& words) {
  try {
    const Syntax known = syntax();
    const ParsedArguments arguments(known, words);
    if (!arguments.has("help"))
      execute(ranks, arguments);
    else if (ranks.first())
      std::cout << helpText(known);
    return 0;
  } catch (const InputError& error) {  // the same on all ranks
    if (ranks.first()) std::cerr << "falciform-distributed: " << error.what() << std::endl;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "falciform-distributed: rank " << ranks.rank() << ": " << error.what() << std::endl;
    ranks.abort(1);
  }
}

}  // namespace
}  // namespace falciform::distributed

int main(int count, char** values) {
  falciform::restartWithBestBlasKernel(values);
  const falciform::distributed::Ranks ranks;
  return falciform::distributed::guarded(ranks, {values + 1, values + count});
}
