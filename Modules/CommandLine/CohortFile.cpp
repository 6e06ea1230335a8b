#include "Modules/CommandLine/CohortFile.h"

#include <algorithm>
#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"

namespace falciform::commandline {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kMostCases = 500;

/// The file's name, for words about it.
class Source {
 public:
  explicit Source(const fs::path& file) : name_("'" + file.string() + "'"), folder_(file.parent_path()) {}

  [[noreturn]] void refuse(const std::string& what) const { throw InputError(name_ + ": " + what); }

  void checkKeys(const Json& object, const std::string& where, const std::set<std::string>& known) const {
    if (!object.is_object()) refuse(where + " must be an object {\"key\": value, ...}");
    for (const auto& [key, unused] : object.items()) {
      if (known.contains(key)) continue;
      std::string all;
      for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
      refuse(where + " has no key '" + key + "'; the keys are " + all);
    }
  }

  /// Empty where the key is absent.
  [[nodiscard]] std::string text(const Json& object, const std::string& where, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end()) return "";
    if (!found->is_string())
      refuse(where + ": '" + key + "' is " + found->dump().substr(0, 40) + "; it must be a text");
    return found->get<std::string>();
  }

  /// Relative paths are from the file's folder.
  [[nodiscard]] fs::path path(const std::string& text) const {
    return fs::path(text).is_absolute() ? fs::path(text) : folder_ / text;
  }

 private:
  std::string name_;
  fs::path folder_;
};

CohortMember readMember(const Json& json, std::size_t place, const Source& source) {
  const std::string where = "case " + std::to_string(place + 1);
  source.checkKeys(json, where, {"case", "name", "preop", "scan", "group"});
  CohortMember member;
  member.name = source.text(json, where, "name");
  member.group = source.text(json, where, "group");
  const std::string folder = source.text(json, where, "case"), preop = source.text(json, where, "preop"),
                    scan = source.text(json, where, "scan");
  if (folder.empty() == (preop.empty() && scan.empty()))
    source.refuse(where + " must name either its folder, 'case', or its files, 'preop' and 'scan'");
  if (!folder.empty()) {
    const fs::path path = source.path(folder);
    if (!fs::exists(path)) source.refuse(where + ": there is no '" + path.string() + "'");
    member.description = readCaseDescription(path);
    if (member.name.empty()) member.name = member.description.name;
    if (const fs::path truth = member.description.folder / "truth_surface.vtp"; fs::exists(truth))
      member.truth = truth;
    return member;
  }
  if (preop.empty() || scan.empty())
    source.refuse(where + " has no '" + (preop.empty() ? "preop" : "scan") + "'; name both surfaces");
  if (member.name.empty()) source.refuse(where + " has no 'name'; give it one");
  member.description.name = member.name;
  member.description.folder = ".";
  member.description.preop = fs::absolute(source.path(preop)).string();
  member.description.scan = fs::absolute(source.path(scan)).string();
  return member;
}

}  // namespace

CohortFile readCohortFile(const fs::path& file) {
  const Json json = readJsonFile(file);
  const Source source(file);
  source.checkKeys(json, "the file", {"name", "target", "cases", "settings", "notice"});
  CohortFile cohort;
  cohort.name = source.text(json, "the file", "name");
  if (cohort.name.empty()) cohort.name = file.stem().string();
  const auto cases = json.find("cases");
  if (cases == json.end() || !cases->is_array() || cases->size() < 3 || cases->size() > kMostCases)
    source.refuse("'cases' must be a list of 3 to " + std::to_string(kMostCases) + " cases");
  for (const Json& entry : *cases) {
    CohortMember member = readMember(entry, cohort.members.size(), source);
    for (const CohortMember& other : cohort.members)
      if (other.name == member.name)
        source.refuse("two cases are called '" + member.name + "'; give each its own 'name'");
    if (member.name.find_first_of("/\\") != std::string::npos || member.name.starts_with("."))
      source.refuse("case '" + member.name +
                    "' cannot be a file's name; leave out '/', '\\' and a leading '.'");
    cohort.members.push_back(std::move(member));
  }
  const std::string target = source.text(json, "the file", "target");
  const auto found = std::find_if(cohort.members.begin(), cohort.members.end(),
                                  [&](const CohortMember& member) { return member.name == target; });
  if (found == cohort.members.end())
    source.refuse(target.empty() ? "there is no 'target'; name the case on whose liver all are compared"
                                 : "the target '" + target + "' is none of the cases");
  cohort.target = static_cast<std::size_t>(found - cohort.members.begin());
  if (const auto settings = json.find("settings"); settings != json.end()) {
    source.checkKeys(*settings, "'settings'",
                     {"import", "patches", "registration", "distance", "normalisation"});
    cohort.caseSettings = *settings;
    cohort.caseSettings.erase("normalisation");
    if (settings->contains("normalisation")) cohort.normalisation = (*settings)["normalisation"];
  }
  return cohort;
}

CohortGroups groupsOf(const CohortFile& cohort) {
  CohortGroups groups;
  std::set<std::string> names;
  for (const CohortMember& member : cohort.members)
    if (!member.group.empty()) names.insert(member.group);
  groups.names.assign(names.begin(), names.end());
  for (const CohortMember& member : cohort.members)
    groups.of.push_back(
        member.group.empty() ? -1 : static_cast<int>(std::distance(names.begin(), names.find(member.group))));
  return groups;
}

}  // namespace falciform::commandline
