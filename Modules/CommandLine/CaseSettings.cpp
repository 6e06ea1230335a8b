#include <set>

#include "Modules/CommandLine/CaseRun.h"
#include "Modules/CommandLine/RegistrationOutputs.h"

namespace falciform::commandline {

namespace {

const std::set<std::string> kParts{"import", "patches", "registration", "distance", "mesh", "update"};

/// Takes `key` out of `json` and returns its text, or `fallback`.
std::string takeText(nlohmann::json& json, const std::string& key, const std::string& fallback) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  if (!json.is_object() || found == json.end()) return fallback;
  if (!found->is_string())
    throw InputError("setting " + key + " is " + found->dump() + "; it must be a text");
  std::string text = *found;
  json.erase(found);
  return text;
}

}  // namespace

void declareCaseSettings(Syntax& syntax) {
  syntax.addSettings(SurfaceImportSettings{}, "Import");
  syntax.rename("labels", "label");
  syntax.addSettings(PatchTransferSettings{}, "Patch transfer");
  syntax.add(
      {.name = "init",
       .kind = ArgumentKind::Text,
       .label = "Initial pose",
       .help = "identity, landmarks (those of the case), or a transform file that maps pre-op mm to scan mm.",
       .group = "Registration"});
  declarePreset(syntax, "Registration");
  syntax.addSettings(RegistrationSettings{}, "Registration");
  syntax.addSettings(DistanceSettings{}, "Distance map");
  const CaseSettings defaults;
  syntax.add({.name = "no-update",
              .kind = ArgumentKind::Flag,
              .label = "No model update",
              .help = "Stops at the rigid registration and its distance map.",
              .group = "Model update"});
  declareImageFrame(syntax, "Model update");
  syntax.addSettings(defaults.update, "Model update", "update-");
  syntax.addSettings(defaults.mesh, "Model update: mesh", "mesh-");
}

CaseSettings caseSettings(const CaseDescription& description, const ParsedArguments& arguments) {
  const nlohmann::json& given = description.settings;
  for (const auto& [key, unused] : given.items())
    if (!kParts.contains(key))
      throw InputError("case.json: settings have no part '" + key +
                       "'; the parts are import, patches, registration, distance, mesh and update");
  const auto part = [&](const char* key) { return given.value(key, nlohmann::json::object()); };
  nlohmann::json registration = part("registration");

  CaseSettings settings;
  settings.preset = takeText(registration, "preset", "default");
  settings.init = takeText(registration, "init", "");
  if (arguments.has("preset")) settings.preset = arguments.text("preset");
  if (arguments.has("init"))
    settings.init = arguments.text("init");
  else if (!settings.init.empty() && settings.init != "identity" && settings.init != "landmarks")
    settings.init = (description.folder / settings.init).string();

  settings.import.labels = description.labels;
  settings.import = arguments.settings(settingsFromJson(part("import"), settings.import));
  settings.patches = arguments.settings(settingsFromJson(part("patches"), settings.patches));
  settings.registration =
      arguments.settings(settingsFromJson(registration, registrationPreset(settings.preset)));
  settings.distance = arguments.settings(settingsFromJson(part("distance"), settings.distance));
  settings.mesh = arguments.settings(settingsFromJson(part("mesh"), settings.mesh), "mesh-");
  settings.update = arguments.settings(settingsFromJson(part("update"), settings.update), "update-");
  settings.withUpdate = !arguments.has("no-update");
  readImageFrame(arguments, settings.imagesIn, settings.gridSpacingMm);
  return settings;
}

nlohmann::json toJson(const CaseSettings& settings) {
  return {{"import", settingsToJson(settings.import)},
          {"patches", settingsToJson(settings.patches)},
          {"registration", settingsToJson(settings.registration)},
          {"distance", settingsToJson(settings.distance)},
          {"mesh", settingsToJson(settings.mesh)},
          {"update", settingsToJson(settings.update)},
          {"images_in", enumToString(settings.imagesIn)},
          {"grid_spacing_mm", settings.gridSpacingMm},
          {"with_update", settings.withUpdate},
          {"preset", settings.preset}};
}

}  // namespace falciform::commandline
