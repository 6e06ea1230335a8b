#include "Modules/CommandLine/DesignInput.h"

#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

std::string atlasPresetsText() {
  const std::vector<std::string>& presets = atlasPresets();
  return listOfNames(std::vector<std::string_view>(presets.begin(), presets.end()));
}

AtlasDesign readDesign(const std::string& text, CommandRun& run) {
  const std::vector<std::string>& presets = atlasPresets();
  if (std::find(presets.begin(), presets.end(), text) != presets.end()) {
    AtlasDesign design = atlasPreset(text);
    design.seed = run.provenance.seed;
    return design;
  }
  std::error_code error;
  if (!fs::exists(text, error))
    throw InputError("'" + text + "' is neither a design file nor a preset; give a JSON file or " +
                     atlasPresetsText());
  run.remember(text);
  try {
    nlohmann::json json = readJsonFile(text);
    if (json.is_object() && !json.contains("seed")) json["seed"] = run.provenance.seed;
    AtlasDesign design = designFromJson(json);
    run.provenance.seed = design.seed;
    return design;
  } catch (const InputError& fault) {
    const std::string what = fault.what(), name = fs::path(text).filename().string();
    throw InputError(what.find(name) == std::string::npos ? "'" + name + "': " + what : what);
  }
}

}  // namespace falciform::commandline
