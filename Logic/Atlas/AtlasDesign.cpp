#include "Logic/Atlas/AtlasDesign.h"

#include <algorithm>

#include "Logic/Core/NumberText.h"

namespace falciform {
namespace {

using nlohmann::json;

constexpr int kMaxMembers = 100000;

const json* found(const json& object, const char* key) {
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

void refuseUnknownKeys(const json& object, const std::vector<std::string_view>& known,
                       const std::string& what) {
  for (const auto& [key, unused] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InputError(what + " has no key '" + key + "'; the keys are " + listOfNames(known));
}

/// Settings of one part, its faults named by the part.
template <class S>
void readPart(const json& design, const char* key, S& settings) {
  const json* part = found(design, key);
  if (part == nullptr) return;
  try {
    settings = settingsFromJson(*part, settings);
  } catch (const InputError& error) {
    throw InputError("the design's '" + std::string(key) + "': " + error.what());
  }
}

std::string textOf(const json& value, const std::string& what) {
  if (!value.is_string()) throw InputError(what + " is no text; write it in double quotes");
  return value.get<std::string>();
}

std::vector<std::string> readRegions(const json& set, const char* key, const std::string& what) {
  std::vector<std::string> names;
  const json* list = found(set, key);
  if (list == nullptr) return names;
  if (!list->is_array())
    throw InputError(what + "'s '" + key + "' is no list of regions; write [\"venaCava\"]");
  const std::vector<std::string>& known = supportRegionNames();
  for (const json& entry : *list) {
    const std::string name = textOf(entry, what + "'s '" + key + "'");
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError(what + " names the region '" + name + "'; choose " +
                       listOfNames(std::vector<std::string_view>(known.begin(), known.end())));
    names.push_back(name);
  }
  return names;
}

std::vector<SupportSet> readSupportSets(const json& list) {
  if (!list.is_array() || list.empty())
    throw InputError(
        "the design's 'supportSets' is no list of sets; write "
        "[{\"name\": \"on the back\", \"fixed\": [\"venaCava\"], \"sliding\": [\"posteriorBed\"]}]");
  std::vector<SupportSet> sets;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const json& entry = list[k];
    const std::string what = "support set " + std::to_string(k + 1);
    if (!entry.is_object()) throw InputError(what + " is no {\"name\": ..., \"fixed\": [...], ...}");
    refuseUnknownKeys(entry, {"name", "fixed", "sliding"}, what);
    SupportSet set{.name = what,
                   .fixed = readRegions(entry, "fixed", what),
                   .sliding = readRegions(entry, "sliding", what)};
    if (const json* name = found(entry, "name")) set.name = textOf(*name, what + "'s name");
    if (set.fixed.empty() && set.sliding.empty())
      throw InputError(what + " names no region; give it 'fixed' or 'sliding' ones");
    sets.push_back(std::move(set));
  }
  return sets;
}

void checkOrder(double low, double high, const char* lowKey, const char* highKey) {
  if (low > high)
    throw InputError("the design's " + std::string(lowKey) + " is " + numberText(low) + " but " + highKey +
                     " is " + numberText(high) + "; exchange them");
}

void checkDirection(double x, double y, double z, const char* part) {
  if (Vector3d(x, y, z).norm() < 1e-6)
    throw InputError(
        "the design's '" + std::string(part) +
        "' has gravity at the CT of no direction; give one, as 0, 1, 0 for a patient on the back");
}

void checkDesign(const AtlasDesign& design) {
  const SampledDesignSettings& s = design.sampled;
  switch (design.kind) {
    case AtlasKind::GravityDirections: {
      const GravityDesignSettings& g = design.gravityDirections;
      checkDirection(g.initialX, g.initialY, g.initialZ, "gravityDirections");
      break;
    }
    case AtlasKind::Packing: {
      checkOrder(design.packing.stepMm, design.packing.maxPushMm, "stepMm", "maxPushMm");
      const double pushes = design.packing.maxPushMm / design.packing.stepMm;
      const double members = pushes * design.packing.places * static_cast<double>(design.supportSets.size());
      if (members > kMaxMembers)
        throw InputError("the design has " + numberText(members) + " members; keep to " +
                         std::to_string(kMaxMembers) + " by a longer stepMm or fewer places");
      break;
    }
    case AtlasKind::Sampled:
      checkOrder(s.minExtentMm, s.maxExtentMm, "minExtentMm", "maxExtentMm");
      checkOrder(s.minPushMm, s.maxPushMm, "minPushMm", "maxPushMm");
      checkOrder(s.minStiffnessRatio, s.maxStiffnessRatio, "minStiffnessRatio", "maxStiffnessRatio");
      checkDirection(s.gravityX, s.gravityY, s.gravityZ, "sampled");
      if (s.setups > s.members)
        throw InputError("the design has " + std::to_string(s.setups) + " setups for " +
                         std::to_string(s.members) + " members; give each setup one member or more");
      if (s.stiffnessLevels > s.setups)
        throw InputError("the design has " + std::to_string(s.stiffnessLevels) + " stiffness levels for " +
                         std::to_string(s.setups) + " setups; give each level one setup or more");
      break;
    case AtlasKind::SurfaceLoads:
      break;
  }
}

Material materialFrom(const TissueSettings& tissue) {
  return {.youngsModulusMPa = tissue.youngsModulusKPa * 1e-3,
          .poissonsRatio = tissue.poissonsRatio,
          .densityKgPerM3 = tissue.densityKgPerM3};
}

}  // namespace

const std::vector<std::string>& supportRegionNames() {
  static const std::vector<std::string> names{"venaCava", "posteriorBed", "leftUnderside", "rightUnderside"};
  return names;
}

const std::vector<std::string>& atlasPresets() {
  static const std::vector<std::string> names{"thesis-gravity", "thesis-packing", "surface-loads"};
  return names;
}

AtlasDesign atlasPreset(const std::string& name) {
  AtlasDesign design;
  if (name == "thesis-gravity") {
    design.kind = AtlasKind::GravityDirections;
  } else if (name == "surface-loads") {
    design.kind = AtlasKind::SurfaceLoads;
  } else if (name == "thesis-packing") {
    // The silicone phantom's. Pushes give the same shapes at any stiffness; only forces change.
    design.liver = {.youngsModulusKPa = 270, .poissonsRatio = 0.47, .densityKgPerM3 = 1040};
  } else {
    const std::vector<std::string>& known = atlasPresets();
    throw InputError("there is no atlas preset '" + name + "'; choose " +
                     listOfNames(std::vector<std::string_view>(known.begin(), known.end())));
  }
  return design;
}

AtlasDesign designFromJson(const json& design) {
  if (!design.is_object()) throw InputError("the design is no JSON object {\"kind\": \"packing\", ...}");
  refuseUnknownKeys(design,
                    {"preset", "kind", "liver", "tumour", "supportSets", "energy", "seed",
                     "gravityDirections", "packing", "sampled", "surfaceLoads"},
                    "the design");
  AtlasDesign result;
  const json *preset = found(design, "preset"), *kind = found(design, "kind");
  if (preset == nullptr && kind == nullptr)
    throw InputError("the design has neither 'kind' nor 'preset'; give one, as {\"kind\": \"packing\"}");
  if (preset != nullptr) result = atlasPreset(textOf(*preset, "the design's 'preset'"));
  if (kind != nullptr)
    result.kind = enumFromString<AtlasKind>("the design's kind", textOf(*kind, "the design's 'kind'"));
  for (const std::string_view other : enumNames(AtlasKind{}))
    if (other != enumToString(result.kind) && design.contains(std::string(other)))
      throw InputError("the design is of kind '" + enumToString(result.kind) + "' but has settings of '" +
                       std::string(other) + "'; take them out or change the kind");
  readPart(design, "liver", result.liver);
  readPart(design, "tumour", result.tumour);
  readPart(design, "gravityDirections", result.gravityDirections);
  readPart(design, "packing", result.packing);
  readPart(design, "sampled", result.sampled);
  readPart(design, "surfaceLoads", result.surfaceLoads);
  if (const json* sets = found(design, "supportSets")) result.supportSets = readSupportSets(*sets);
  const FieldInfo energyInfo{"energy", "Energy", "", 0.5, 1, ""};
  if (const json* energy = found(design, "energy")) {
    if (!energy->is_number()) refuseJson(energyInfo, *energy, "a number");
    result.energy = energy->get<double>();
    checkRange(energyInfo, result.energy);
  }
  if (const json* seed = found(design, "seed")) {
    if (!seed->is_number_unsigned())
      refuseJson({"seed", "Seed", "", 0, 0, ""}, *seed, "a whole number from 0");
    result.seed = seed->get<std::uint64_t>();
  }
  checkDesign(result);
  return result;
}

json toJson(const AtlasDesign& design) {
  json result{{"kind", enumToString(design.kind)},
              {"liver", settingsToJson(design.liver)},
              {"tumour", settingsToJson(design.tumour)},
              {"energy", design.energy},
              {"seed", design.seed},
              {"supportSets", json::array()}};
  for (const SupportSet& set : design.supportSets)
    result["supportSets"].push_back({{"name", set.name}, {"fixed", set.fixed}, {"sliding", set.sliding}});
  switch (design.kind) {
    case AtlasKind::GravityDirections:
      result["gravityDirections"] = settingsToJson(design.gravityDirections);
      break;
    case AtlasKind::Packing:
      result["packing"] = settingsToJson(design.packing);
      break;
    case AtlasKind::Sampled:
      result["sampled"] = settingsToJson(design.sampled);
      break;
    case AtlasKind::SurfaceLoads:
      result["surfaceLoads"] = settingsToJson(design.surfaceLoads);
      break;
  }
  return result;
}

std::vector<Material> materialsOf(const AtlasDesign& design, double stiffnessRatio) {
  std::vector<Material> materials{materialFrom(design.liver), materialFrom(design.tumour)};
  if (stiffnessRatio > 0) materials[1].youngsModulusMPa = stiffnessRatio * materials[0].youngsModulusMPa;
  return materials;
}

}  // namespace falciform
