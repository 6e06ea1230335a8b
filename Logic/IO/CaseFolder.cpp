#include "Logic/IO/CaseFolder.h"

#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/SupportFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/UpdateFiles.h"
#include "Logic/IO/VolumeFiles.h"

namespace falciform {

namespace {

namespace fs = std::filesystem;

/// "Portal vein (left)" -> "Portal_vein_left", different for different names.
std::string fileNameFor(const std::string& name, std::set<std::string>& taken) {
  std::string safe;
  for (const unsigned char c : name.substr(0, 60))
    if (std::isalnum(c) || c == '-')
      safe += static_cast<char>(c);
    else if (!safe.empty() && safe.back() != '_')
      safe += '_';
  while (!safe.empty() && safe.back() == '_') safe.pop_back();
  if (safe.empty()) safe = "structure";
  std::string unique = safe;
  for (int k = 2; !taken.insert(unique).second; ++k) unique = safe + "-" + std::to_string(k);
  return unique + ".vtp";
}

/// What the user wrote into case.json and the document does not hold is kept when the case is saved over it.
CaseDescription keptFrom(const fs::path& folder, const Case& document) {
  CaseDescription kept;
  if (fs::exists(folder / "case.json")) {
    const CaseDescription old = readCaseDescription(folder);
    kept.settings = old.settings;
    if (fs::exists(folder / old.view)) kept.view = old.view;
    kept.targets = old.targets;
    kept.truthTargets = old.truthTargets;
    if (document.labels()) kept.labels = old.labels;
  }
  return kept;
}

class CaseSaver {
 public:
  CaseSaver(const fs::path& folder, Overwrite overwrite) : folder_(folder), overwrite_(overwrite) {}

  std::string save(const std::shared_ptr<const Surface>& surface, const std::string& file) const {
    if (!surface) return {};
    writeSurface(folder_ / file, *surface, overwrite_);
    return file;
  }
  std::string save(const Landmarks& landmarks, const std::string& file) const {
    if (landmarks.points.empty()) return {};
    writeLandmarks(folder_ / file, landmarks, overwrite_);
    return file;
  }
  std::string save(const std::shared_ptr<const LabelMap>& labels, const std::string& file) const {
    if (!labels) return {};
    writeLabelMap(folder_ / file, *labels, overwrite_);
    return file;
  }
  std::string save(const std::shared_ptr<const Image>& ct, const std::string& file) const {
    if (!ct) return {};
    writeImage(folder_ / file, *ct, overwrite_);
    return file;
  }
  std::string save(const std::shared_ptr<const RegistrationResult>& result, bool stale,
                   const std::string& file) const {
    if (!result) return {};
    nlohmann::json json = toJson(*result);
    json["stale"] = stale;
    writeJsonFile(folder_ / file, json, overwrite_);
    return file;
  }
  std::string save(const std::shared_ptr<const DistanceMap>& map, const std::string& file) const {
    if (!map) return {};
    nlohmann::json json = toJson(*map);
    json["preop_surface"] = "distance_preop.vtp";
    json["scan_surface"] = "distance_scan.vtp";
    writeSurface(folder_ / "distance_preop.vtp", map->preop, overwrite_);
    writeSurface(folder_ / "distance_scan.vtp", map->scan, overwrite_);
    writeJsonFile(folder_ / file, json, overwrite_);
    return file;
  }
  std::string save(const std::shared_ptr<const SupportPainting>& supports, const std::string& file) const {
    if (!supports) return {};
    writeJsonFile(folder_ / file, toJson(*supports), overwrite_);
    return file;
  }
  std::vector<std::pair<std::string, std::string>> save(
      const std::map<std::string, std::shared_ptr<const Surface>>& structures,
      const std::string& into = "structures") const {
    std::vector<std::pair<std::string, std::string>> files;
    std::set<std::string> taken;
    if (!structures.empty()) makeFolder(folder_ / into);
    for (const auto& [name, surface] : structures)
      files.emplace_back(name, save(surface, into + "/" + fileNameFor(name, taken)));
    return files;
  }
  std::string save(const std::shared_ptr<const KeptUpdate>& update, bool stale,
                   const std::string& file) const {
    if (!update || !update->surface) return {};
    makeFolder(folder_ / "update");
    nlohmann::json json = toJson(*update);
    json["stale"] = stale;
    json["surface"] = save(update->surface, "update/updated.vtp");
    json["structures"] = nlohmann::json::object();
    for (const auto& [name, structure] : save(update->structures, "update/structures"))
      json["structures"][name] = structure;
    writeJsonFile(folder_ / file, json, overwrite_);
    return file;
  }

 private:
  fs::path folder_;
  Overwrite overwrite_;
};

class CaseOpener {
 public:
  explicit CaseOpener(CaseDescription description) : from_(std::move(description)) {}

  /// Everything is read before the document is touched: a damaged file leaves it as it was.
  std::vector<std::string> fill(Case& document) {
    const auto labels =
        from_.labelMap.empty() ? nullptr : shared(take(readLabelMap(from_.folder / from_.labelMap)));
    const auto preop = surface(from_.preop), scan = surface(from_.scan);
    std::map<std::string, std::shared_ptr<const Surface>> structures;
    for (const auto& [name, file] : from_.structures) structures[name] = surface(file);
    const Landmarks preopLandmarks = landmarks(from_.preopLandmarks),
                    scanLandmarks = landmarks(from_.scanLandmarks);
    const Landmarks targets = landmarks(from_.targets), truthTargets = landmarks(from_.truthTargets);
    const auto ct = from_.ct.empty() ? nullptr : shared(take(readImage(from_.folder / from_.ct)));
    bool stale = false;
    const auto registration = readRegistration(stale);
    const auto distance = readDistance();
    const auto supports = readSupports(preop);
    bool updateStale = false;
    const auto update = readUpdate(preop, updateStale);

    document.clear();
    document.setName(from_.name);
    if (labels) document.setLabels(labels);
    if (registration && stale)
      document.setRegistration(registration);  // before the surfaces: then it is stale again
    if (preop) document.setPreop(preop);
    if (scan) document.setScan(scan);
    if (registration && !stale) document.setRegistration(registration);
    for (const auto& [name, structure] : structures) document.setStructure(name, structure);
    if (!preopLandmarks.points.empty()) document.setPreopLandmarks(preopLandmarks);
    if (!scanLandmarks.points.empty()) document.setScanLandmarks(scanLandmarks);
    if (!targets.points.empty()) document.setTargets(targets);
    if (!truthTargets.points.empty()) document.setTruthTargets(truthTargets);
    if (ct) document.setCt(ct);
    if (distance) document.setDistance(distance);
    if (supports) document.setSupports(supports);
    if (update) document.setUpdate(update, updateStale);
    document.setUnmodified();
    if (!from_.preopPatches.empty())
      warnings_.push_back("the patches of '" + from_.preopPatches +
                          "' are not on the surface yet; carry them over once the surface is there");
    return warnings_;
  }

 private:
  template <class T>
  T take(Loaded<T> loaded) {
    warnings_.insert(warnings_.end(), loaded.warnings.begin(), loaded.warnings.end());
    return std::move(loaded.value);
  }
  template <class T>
  static std::shared_ptr<const T> shared(T value) {
    return std::make_shared<const T>(std::move(value));
  }
  std::shared_ptr<const Surface> surface(const std::string& file) {
    return file.empty() ? nullptr : shared(take(readSurface(from_.folder / file)));
  }
  Landmarks landmarks(const std::string& file) {
    return file.empty() ? Landmarks{} : take(readLandmarks(from_.folder / file));
  }

  /// A whole saved result, or just a transform file.
  std::shared_ptr<const RegistrationResult> readRegistration(bool& stale) {
    if (from_.registration.empty()) return nullptr;
    const fs::path file = from_.folder / from_.registration;
    if (file.extension() == ".json")
      if (const nlohmann::json json = readJsonFile(file);
          json.is_object() && json.contains("scan_from_preop")) {
        stale = json.value("stale", nlohmann::json(false)) == true;
        return shared(registrationFromJson(json));
      }
    RegistrationResult result;
    result.scanFromPreop = readTransform(file);
    result.stopReason = "read from " + file.filename().string();
    return shared(std::move(result));
  }

  std::shared_ptr<const DistanceMap> readDistance() {
    if (from_.distance.empty()) return nullptr;
    const fs::path file = from_.folder / from_.distance;
    const nlohmann::json json = readJsonFile(file);
    for (const char* key : {"preop_surface", "scan_surface"})
      if (!json.is_object() || !json.contains(key) || !json[key].is_string())
        throw InputError(file.filename().string() + " has no text '" + key +
                         "'; compute the distance map again");
    const auto beside = [&](const char* key) {
      return take(readSurface(file.parent_path() / json[key].get<std::string>()));
    };
    Surface preop = beside("preop_surface"), scan = beside("scan_surface");
    return shared(distanceFromJson(json, std::move(preop), std::move(scan)));
  }

  std::shared_ptr<const SupportPainting> readSupports(const std::shared_ptr<const Surface>& preop) {
    if (from_.supports.empty()) return nullptr;
    if (!preop)
      throw InputError("case.json: 'supports' lie on the surface 'preop', which is not given; name it too");
    return shared(supportPaintingFromJson(readJsonFile(from_.folder / from_.supports), preop->size()));
  }

  std::shared_ptr<const KeptUpdate> readUpdate(const std::shared_ptr<const Surface>& preop, bool& stale) {
    if (from_.update.empty()) return nullptr;
    const fs::path file = from_.folder / from_.update;
    const nlohmann::json json = readJsonFile(file);
    KeptUpdate update = keptUpdateFromJson(json);
    stale = json.value("stale", nlohmann::json(false)) == true;
    const auto named = [&](const nlohmann::json& value, const std::string& key) {
      if (!value.is_string()) throw InputError(file.filename().string() + ": '" + key + "' must name a file");
      return shared(take(readSurface(file.parent_path() / value.get<std::string>())));
    };
    update.surface = named(json.value("surface", nlohmann::json()), "surface");
    if (!preop || update.surface->size() != preop->size())
      throw InputError(file.filename().string() +
                       " is of another surface than 'preop'; update the model again");
    const nlohmann::json structures = json.value("structures", nlohmann::json::object());
    if (!structures.is_object())
      throw InputError(file.filename().string() + ": 'structures' must be an object");
    for (const auto& [name, value] : structures.items())
      update.structures[name] = named(value, "structures." + name);
    return shared(std::move(update));
  }

  CaseDescription from_;
  std::vector<std::string> warnings_;
};

}  // namespace

void saveCase(const Case& document, const fs::path& folder, Overwrite overwrite, const nlohmann::json& view) {
  makeFolder(folder);
  if (overwrite == Overwrite::Refuse && fs::exists(folder / "case.json"))
    throw InputError("'" + folder.string() +
                     "' holds a case already; give --force to replace it, or choose another folder");
  CaseDescription description = keptFrom(folder, document);
  const CaseSaver saver(folder, overwrite);
  description.folder = folder;
  description.name = document.name().empty() ? "Untitled" : document.name();
  description.labelMap = saver.save(document.labels(), "labels.nii.gz");
  description.preop = saver.save(document.preop(), "preop.vtp");
  description.scan = saver.save(document.scan(), "scan.vtp");
  description.structures = saver.save(document.structures());
  description.preopLandmarks = saver.save(document.preopLandmarks(), "preop_landmarks.mrk.json");
  description.scanLandmarks = saver.save(document.scanLandmarks(), "scan_landmarks.mrk.json");
  description.registration =
      saver.save(document.registration(), document.registrationStale(), "registration.json");
  description.distance = saver.save(document.distance(), "distance.json");
  description.supports = saver.save(document.supports(), "supports.json");
  description.update = saver.save(document.update(), document.updateStale(), "update.json");
  description.ct = saver.save(document.ct(), "ct.nii.gz");
  if (!view.empty()) writeJsonFile(folder / (description.view = "view.json"), view, overwrite);
  if (!document.targets().points.empty())
    description.targets = saver.save(document.targets(), "targets.mrk.json");
  if (!document.truthTargets().points.empty())
    description.truthTargets = saver.save(document.truthTargets(), "truth_targets.mrk.json");
  writeCaseDescription(description, overwrite);  // last: until then the old case.json stands
}

std::vector<std::string> openCase(Case& document, const fs::path& folderOrFile) {
  return openCase(document, readCaseDescription(folderOrFile));
}

std::vector<std::string> openCase(Case& document, const CaseDescription& description) {
  return CaseOpener(description).fill(document);
}

}  // namespace falciform
