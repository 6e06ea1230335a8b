#include "Logic/IO/SupportFiles.h"

#include "Logic/Core/Errors.h"
#include "Logic/Core/Settings.h"

namespace falciform {
namespace {

using Json = nlohmann::json;

constexpr char kWhat[] = "supports";

[[noreturn]] void refuse(const std::string& key, const std::string& expected) {
  throw InputError(std::string(kWhat) + ": '" + key + "' must be " + expected);
}

const Json& member(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) throw InputError(std::string(kWhat) + " lacks '" + key + "'; save the case again");
  return *found;
}

double number(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_number()) refuse(key, "a number");
  return value.get<double>();
}

std::string text(const Json& json, const char* key) {
  const Json& value = member(json, key);
  if (!value.is_string()) refuse(key, "a text");
  return value.get<std::string>();
}

std::int64_t whole(const Json& value, const char* key) {
  if (!value.is_number_integer()) refuse(key, "whole numbers");
  return value.get<std::int64_t>();
}

SupportRegion regionFrom(const Json& json) {
  if (!json.is_object()) refuse("regions", "a list of objects");
  SupportRegion region;
  region.name = text(json, "name");
  region.kind = enumFromString<SupportRegionKind>("kind", text(json, "kind"));
  region.pushMm = number(json, "push_mm");
  return region;
}

/// Never more labels than there are points, whatever the counts say.
std::vector<int> labelsFrom(const Json& runs, Index points) {
  if (!runs.is_array() || runs.size() % 2 != 0) refuse("label_runs", "a list [label, count, ...]");
  std::vector<int> labels;
  for (std::size_t i = 0; i < runs.size(); i += 2) {
    const std::int64_t label = whole(runs[i], "label_runs"), count = whole(runs[i + 1], "label_runs");
    if (label < 0 || label > support_label::kMax) refuse("label_runs", "made of labels from 0 to 255");
    if (count < 1 || count > points - static_cast<Index>(labels.size()))
      refuse("label_runs", "of the " + std::to_string(points) + " points of the pre-operative surface");
    labels.insert(labels.end(), static_cast<std::size_t>(count), static_cast<int>(label));
  }
  return labels;
}

}  // namespace

Json toJson(const SupportPainting& painting) {
  Json regions = Json::array(), runs = Json::array();
  for (const auto& [label, region] : painting.regions)
    regions.push_back({{"label", label},
                       {"name", region.name},
                       {"kind", enumToString(region.kind)},
                       {"push_mm", region.pushMm}});
  for (std::size_t begin = 0; begin < painting.labels.size();) {
    std::size_t end = begin;
    while (end < painting.labels.size() && painting.labels[end] == painting.labels[begin]) ++end;
    runs.push_back(painting.labels[begin]);
    runs.push_back(end - begin);
    begin = end;
  }
  return {{"schema", 1},
          {"points", painting.labels.size()},
          {"turn_deg", painting.turnDeg},
          {"regions", regions},
          {"label_runs", runs}};
}

SupportPainting supportPaintingFromJson(const Json& json, Index points) {
  if (!json.is_object()) throw InputError(std::string(kWhat) + " is no JSON object; save the case again");
  if (whole(member(json, "schema"), "schema") != 1)
    throw InputError(std::string(kWhat) + " is of a later version; open it with a newer program");
  SupportPainting painting;
  painting.turnDeg = number(json, "turn_deg");
  const Json& regions = member(json, "regions");
  if (!regions.is_array()) refuse("regions", "a list of objects");
  for (const Json& region : regions) {
    SupportRegion read = regionFrom(region);  // first: says so if it is no object
    painting.regions[static_cast<int>(whole(member(region, "label"), "label"))] = std::move(read);
  }
  painting.labels = labelsFrom(member(json, "label_runs"), points);
  checkSupportPainting(painting, points, kWhat);
  return painting;
}

}  // namespace falciform
