#include "Logic/Atlas/AtlasHead.h"

#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

nlohmann::json jsonOf(const Hdf5Reader& file, const char* name, const std::filesystem::path& path) {
  nlohmann::json json = nlohmann::json::parse(file.text(name), nullptr, false);
  if (!json.is_object()) refuseInconsistent(path, std::string(name) + " is no JSON object");
  return json;
}

}  // namespace

void refuseInconsistent(const std::filesystem::path& file, const std::string& what) {
  throw InputError("'" + file.string() + "' is inconsistent: " + what + "; build the atlas anew");
}

void writeAtlasHead(Hdf5Writer& file, const AtlasDesign& design, const nlohmann::json& given) {
  const nlohmann::json provenance = given.is_object() ? given : nlohmann::json::object();
  file.attribute("falciform_atlas_version", kAtlasFileVersion);
  file.attribute("program", provenance.value("program", "falciform") + " " + provenance.value("version", ""));
  file.attribute("created_utc", provenance.value("started_utc", ""));
  const auto replace = nlohmann::json::error_handler_t::replace;  // names of files may be no UTF-8
  file.text("design_json", toJson(design).dump(2));
  file.text("provenance_json", provenance.dump(2, ' ', false, replace));
}

AtlasHead readAtlasHead(const Hdf5Reader& file, const std::filesystem::path& path) {
  nlohmann::json provenance = jsonOf(file, "provenance_json", path);
  return {designFromJson(jsonOf(file, "design_json", path)), std::move(provenance)};
}

}  // namespace falciform
