#include "Logic/Atlas/LoadFiles.h"
#include "Modules/CommandLine/AtlasFigures.h"
#include "Modules/CommandLine/AtlasPicture.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/PictureTiles.h"

namespace falciform::commandline {

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  syntax.add({.name = "members",
              .kind = Flag,
              .label = "Members",
              .help = "Also list every setup and every member.",
              .group = group});
  syntax.add({.name = "picture",
              .kind = File,
              .label = "Picture",
              .help = "Also draw supports and some members, .png.",
              .output = true,
              .group = group});
  syntax.add({.name = "show",
              .kind = Integers,
              .label = "Members to draw",
              .help = "Numbers of members in the picture, from 0; else five that tell most.",
              .group = group});
  syntax.add({.name = "FILE",
              .kind = File,
              .label = "Atlas",
              .help = "Atlas that falciform atlas build wrote, .h5.",
              .required = true,
              .positional = true,
              .group = group});
  for (const ResultField& field : atlasResultFields()) syntax.addResult(field);
}

void tellBuilt(const nlohmann::json& provenance, CommandRun& run) {
  run.figures["built_utc"] = provenance.value("started_utc", "");
  run.say("built " + provenance.value("started_utc", "") + " by falciform " +
          provenance.value("version", ""));
}

void tellLoads(const std::filesystem::path& file, const ParsedArguments& arguments, CommandRun& run) {
  for (const char* asked : {"picture", "members"})
    if (arguments.has(asked))
      throw InputError("--" + std::string(asked) +
                       " is given for an atlas of surface loads, which has no members; leave it out");
  const StoredLoads stored = readLoadAtlas(file);
  run.remember(file);
  run.figures = loadFigures(stored.atlas);
  for (const std::string& line : loadLines(stored.atlas)) run.say(line);
  tellBuilt(stored.provenance, run);
}

void execute(const ParsedArguments& arguments, CommandRun& run) {
  const std::filesystem::path file = arguments.path("FILE"), picture = picturePath(arguments);
  if (arguments.has("show") && picture.empty())
    throw InputError("--show is given without --picture; name the picture to draw, .png");
  if (!picture.empty()) run.outputs.announce(picture);
  run.progress.report(0, "Reading");
  if (atlasKindOf(file) == AtlasKind::SurfaceLoads) {
    tellLoads(file, arguments, run);
    return;
  }
  const StoredAtlas stored = readAtlas(file);
  run.remember(file);
  run.figures = atlasFigures(stored.atlas);
  for (const std::string& line : atlasLines(stored.atlas)) run.say(line);
  tellBuilt(stored.provenance, run);
  run.warn(atlasWarnings(stored.atlas));
  if (!picture.empty()) {
    std::vector<Index> shown = telling(stored.atlas);
    if (arguments.has("show")) {
      const std::vector<int> asked = parseIntegers("--show", arguments.text("show"));
      shown.assign(asked.begin(), asked.end());
    }
    run.progress.report(0.3, "Drawing");
    saveAtlasPicture(stored.atlas, shown, run.outputs.staged(picture), Overwrite::Replace);
  }
  if (!arguments.has("members")) return;
  for (const std::string& line : setupLines(stored.atlas)) run.say(line);
  for (const std::string& line : memberLines(stored.atlas)) run.say(line);
}

}  // namespace

Command atlasInfoCommand() {
  return {"atlas info", "Atlas information", "Says what an atlas holds: rank, energy, members, supports.",
          declare, execute};
}

}  // namespace falciform::commandline
