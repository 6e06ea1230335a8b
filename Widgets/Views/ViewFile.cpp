#include "Widgets/Views/ViewFile.h"

#include <algorithm>
#include <charconv>

namespace falciform {

namespace {

using Json = nlohmann::json;

/// Three numbers in [0, 1], or what was there.
std::array<double, 3> colourOf(const Json& json, std::array<double, 3> colour) {
  if (!json.is_array() || json.size() != 3) return colour;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!json[k].is_number()) return colour;
  }
  for (std::size_t k = 0; k < 3; ++k) colour[k] = std::clamp(json[k].get<double>(), 0.0, 1.0);
  return colour;
}

bool flagOf(const Json& json, const char* key, bool otherwise) {
  const auto found = json.find(key);
  return found != json.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

Json valueOf(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? Json() : *found;
}

}  // namespace

Json toJson(const ViewOptions& options) {
  Json parts = Json::object(), patches = Json::object();
  for (const auto& [part, look] : options.looks)
    parts[part] = {{"visible", look.visible}, {"colour", look.colour}, {"opacity", look.opacity}};
  for (const auto& [label, look] : options.patchLooks)
    patches[std::to_string(label)] = {{"visible", look.visible}, {"colour", look.colour}};
  return {{"parts", parts},
          {"patches", patches},
          {"ct_slices", options.slicesWanted},
          {"grey_window", {{"level_hu", options.greyWindow.level}, {"width_hu", options.greyWindow.width}}}};
}

void readView(const Json& json, ViewOptions& options) {
  options.looks.clear();
  options.patchLooks.clear();
  if (!json.is_object()) return;
  const Json parts = valueOf(json, "parts"), patches = valueOf(json, "patches");
  if (parts.is_object())
    for (const auto& [part, value] : parts.items()) {
      if (!value.is_object()) continue;
      PartLook look = defaultLook(part);
      look.visible = flagOf(value, "visible", look.visible);
      look.colour = colourOf(valueOf(value, "colour"), look.colour);
      if (const Json opacity = valueOf(value, "opacity"); opacity.is_number())
        look.opacity = std::clamp(opacity.get<double>(), 0.0, 1.0);
      options.looks[part] = look;
    }
  if (patches.is_object())
    for (const auto& [name, value] : patches.items()) {
      int label = 0;
      const auto read = std::from_chars(name.data(), name.data() + name.size(), label);
      if (read.ec != std::errc() || label < 1 || label > patch::kMax || !value.is_object()) continue;
      PatchLook look = ViewState().patchLook(label);
      look.visible = flagOf(value, "visible", look.visible);
      look.colour = colourOf(valueOf(value, "colour"), look.colour);
      options.patchLooks[label] = look;
    }
  if (const Json window = valueOf(json, "grey_window"); window.is_object()) {
    const Json level = valueOf(window, "level_hu"), width = valueOf(window, "width_hu");
    if (level.is_number() && width.is_number())
      options.greyWindow = {std::clamp(level.get<double>(), -1e5, 1e5),
                            std::clamp(width.get<double>(), 1.0, 1e5)};
  }
  options.slicesWanted = flagOf(json, "ct_slices", options.slicesWanted);
}

}  // namespace falciform
