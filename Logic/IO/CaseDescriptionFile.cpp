#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/JsonFile.h"

namespace falciform {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr char kCaseFile[] = "case.json";

struct TextKey {
  const char* key;
  std::string CaseDescription::*member;
};

/// Keys that name a file.
constexpr TextKey kFileKeys[]{{"labelMap", &CaseDescription::labelMap},
                              {"preop", &CaseDescription::preop},
                              {"preopPatches", &CaseDescription::preopPatches},
                              {"scan", &CaseDescription::scan},
                              {"preopLandmarks", &CaseDescription::preopLandmarks},
                              {"scanLandmarks", &CaseDescription::scanLandmarks},
                              {"registration", &CaseDescription::registration},
                              {"distance", &CaseDescription::distance},
                              {"supports", &CaseDescription::supports},
                              {"update", &CaseDescription::update},
                              {"view", &CaseDescription::view},
                              {"ct", &CaseDescription::ct},
                              {"targets", &CaseDescription::targets},
                              {"truthTargets", &CaseDescription::truthTargets}};

[[noreturn]] void refuse(const std::string& key, const std::string& expected) {
  throw InputError("case.json: '" + key + "' must be " + expected);
}

std::string textOf(const Json& value, const std::string& key) {
  if (!value.is_string() || value.get_ref<const std::string&>().empty())
    refuse(key, "a text that is not empty");
  return value.get<std::string>();
}

std::vector<int> labelsOf(const Json& value) {
  std::vector<int> labels;
  if (!value.is_array()) refuse("labels", "a list of whole numbers from 1 to 65535");
  for (const Json& label : value) {
    if (!label.is_number_integer() || label.get<std::int64_t>() < 1 || label.get<std::int64_t>() > 65535)
      refuse("labels", "a list of whole numbers from 1 to 65535");
    labels.push_back(label.get<int>());
  }
  return labels;
}

std::vector<std::pair<std::string, std::string>> structuresOf(const Json& value) {
  if (!value.is_object()) refuse("structures", "an object {\"name\": \"file\", ...}");
  std::vector<std::pair<std::string, std::string>> structures;
  for (const auto& [name, file] : value.items())
    structures.emplace_back(name, textOf(file, "structures." + name));
  return structures;
}

void refuseUnknownKeys(const Json& json) {
  std::set<std::string> known{"name", "labels", "structures", "settings", "notice"};
  for (const TextKey& file : kFileKeys) known.insert(file.key);
  for (const auto& [key, unused] : json.items()) {
    if (known.contains(key)) continue;
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    throw InputError("case.json has no key " + inQuotes(key) + "; the keys are " + all);
  }
}

/// Relative to the case's folder, so that the folder can be moved.
std::string relativeTo(const fs::path& folder, const std::string& file) {
  const fs::path path(file);
  return path.is_absolute() ? fs::proximate(path, fs::absolute(folder)).generic_string()
                            : path.generic_string();
}

}  // namespace

CaseDescription readCaseDescription(const fs::path& folderOrFile) {
  const fs::path file = fs::is_directory(folderOrFile) ? folderOrFile / kCaseFile : folderOrFile;
  const Json json = readJsonFile(file);
  if (!json.is_object())
    throw InputError(file.filename().string() + " must hold an object {\"name\": ..., \"scan\": ...}");
  refuseUnknownKeys(json);
  CaseDescription description;
  description.folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!json.contains("name")) throw InputError("case.json has no 'name'; give the case one");
  description.name = textOf(json["name"], "name");
  for (const TextKey& entry : kFileKeys)
    if (json.contains(entry.key)) description.*entry.member = textOf(json[entry.key], entry.key);
  if (json.contains("labels")) description.labels = labelsOf(json["labels"]);
  if (json.contains("structures")) description.structures = structuresOf(json["structures"]);
  if (json.contains("settings")) {
    if (!json["settings"].is_object()) refuse("settings", "an object {\"registration\": {...}, ...}");
    description.settings = json["settings"];
  }
  return description;
}

void writeCaseDescription(const CaseDescription& description, Overwrite overwrite) {
  Json json{{"name", description.name}};
  for (const TextKey& entry : kFileKeys)
    if (const std::string& file = description.*entry.member; !file.empty())
      json[entry.key] = relativeTo(description.folder, file);
  if (!description.labels.empty()) json["labels"] = description.labels;
  for (const auto& [name, file] : description.structures)
    json["structures"][name] = relativeTo(description.folder, file);
  if (!description.settings.empty()) json["settings"] = description.settings;
  writeJsonFile(description.folder / kCaseFile, json, overwrite);
}

}  // namespace falciform
