#include "Logic/IO/MarkupFiles.h"

#include <optional>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

constexpr char kSchema[] =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
    "markups-schema-v1.0.3.json#";

using Json = nlohmann::json;

/// Adds a point given in LPS or RAS.
void add(Loaded<Landmarks>& loaded, const std::string& label, Vector3d position, bool ras,
         const std::string& name) {
  if (!position.allFinite() || position.cwiseAbs().maxCoeff() > 1e6)
    throw InputError(name + ": the position of '" + label +
                     "' is not finite or beyond 1e6 mm; place it again");
  if (ras) position.head<2>() *= -1;
  loaded.value.points.push_back({label, position});
}

std::string text(const Json& object, const char* key, const std::string& fallback) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : fallback;
}

/// Millimetres a unit of the file is: coordinateUnits is "mm", "um", or a coded triple that begins with the
/// unit.
double scaleOf(const Json& markup, const std::string& name) {
  const auto units = markup.find("coordinateUnits");
  if (units == markup.end()) return 1;
  const Json first = units->is_array() && !units->empty() ? units->front() : *units;
  if (first == "mm") return 1;
  if (first == "um") return 1e-3;
  throw InputError(name + ": coordinateUnits are " + first.dump().substr(0, 20) + "; use mm");
}

std::optional<Vector3d> positionOf(const Json& point, const std::string& label, const std::string& name) {
  if (text(point, "positionStatus", "defined") != "defined") return std::nullopt;
  const auto position = point.find("position");
  if (position == point.end() || position->is_null()) return std::nullopt;
  Vector3d value;
  if (!position->is_array() || position->size() != 3)
    throw InputError(name + ": the position of '" + label + "' is not a list of 3 numbers; place it again");
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(*position)[k].is_number())
      throw InputError(name + ": the position of '" + label + "' is not a list of 3 numbers; place it again");
    value[static_cast<Index>(k)] = (*position)[k].get<double>();
  }
  return value;
}

Loaded<Landmarks> readMarkupJson(const std::filesystem::path& file, const std::string& name) {
  const Json json = readJsonFile(file);
  const auto markups = json.is_object() ? json.find("markups") : json.end();
  if (!json.is_object() || markups == json.end() || !markups->is_array() || markups->empty() ||
      !markups->front().is_object())
    throw InputError(name + " holds no markups ({\"markups\": [...]}); save the points as .mrk.json again");
  Loaded<Landmarks> loaded;
  if (markups->size() > 1)
    loaded.warnings.push_back(name + " holds " + std::to_string(markups->size()) +
                              " lists; the first was read");
  const Json& markup = markups->front();
  const std::string system = text(markup, "coordinateSystem", "LPS");
  if (system != "LPS" && system != "RAS")
    throw InputError(name + ": coordinateSystem is '" + system.substr(0, 20) + "'; use LPS or RAS");
  const double scale = scaleOf(markup, name);
  const auto points = markup.find("controlPoints");
  if (points == markup.end() || !points->is_array())
    throw InputError(name + " has no list 'controlPoints'; save the points again");
  for (const Json& point : *points) {
    const std::string label = text(point, "label", std::to_string(loaded.value.points.size() + 1));
    if (const auto position = point.is_object() ? positionOf(point, label, name) : std::nullopt)
      add(loaded, label, *position * scale, system == "RAS", name);
    else
      loaded.warnings.push_back(name + ": point '" + label + "' is not placed and was left out");
  }
  if (const auto ours = json.find("falciform"); ours != json.end() && ours->is_object())
    loaded.value.frame = text(*ours, "frame", "LPS");
  return loaded;
}

/// Comma-separated cells; a cell in quotes may hold commas and doubled quotes.
std::vector<std::string> cellsOf(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  return cells;
}

std::string valueAfterEquals(std::string_view line) {
  line.remove_prefix(std::min(line.find('='), line.size() - 1) + 1);
  return std::string(nextWord(line));
}

Loaded<Landmarks> readFcsv(const std::string& bytes, const std::string& name) {
  Loaded<Landmarks> loaded;
  bool ras = true, stated = false;
  std::size_t labelColumn = 11;  // id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,...
  TextCursor cursor(bytes);
  for (std::string_view line; cursor.nextLine(line);) {
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (line.front() == '#') {
      if (line.find("CoordinateSystem") != std::string_view::npos) {
        const std::string system = valueAfterEquals(line);
        stated = true;
        ras = system == "RAS" || system == "0";
        if (!ras && system != "LPS" && system != "1")
          throw InputError(name + ": CoordinateSystem is '" + system.substr(0, 20) + "'; use LPS or RAS");
      } else if (line.find("columns") != std::string_view::npos) {
        const std::vector<std::string> names = cellsOf(valueAfterEquals(line));
        for (std::size_t k = 0; k < names.size(); ++k)
          if (names[k] == "label") labelColumn = k;
      }
      continue;
    }
    const std::vector<std::string> cells = cellsOf(line);
    Vector3d position;
    for (std::size_t k = 0; k < 3; ++k)
      if (cells.size() < 4 || !parseNumber(std::string_view(cells[k + 1]), position[static_cast<Index>(k)]))
        throw InputError(name + ", line " + std::to_string(cursor.line()) +
                         ": no x, y, z in columns 2 to 4; save the points again");
    const bool named = cells.size() > labelColumn && !cells[labelColumn].empty();
    add(loaded, named ? cells[labelColumn] : cells[0], position, ras, name);
  }
  if (!stated)
    loaded.warnings.push_back(
        name + " does not say its CoordinateSystem; RAS is assumed, as 3D Slicer does for .fcsv");
  return loaded;
}

}  // namespace

Loaded<Landmarks> readLandmarks(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  Loaded<Landmarks> loaded;
  if (name.ends_with(".fcsv"))
    loaded = readFcsv(readTextFile(file), name);
  else if (name.ends_with(".json"))
    loaded = readMarkupJson(file, name);
  else
    throw InputError("'" + name + "' is no landmark file; give .mrk.json or .fcsv");
  if (loaded.value.points.empty())
    throw InputError(name + " holds no placed points; place landmarks and save them again");
  return loaded;
}

void writeLandmarks(const std::filesystem::path& file, const Landmarks& landmarks, Overwrite overwrite) {
  const std::string name = file.filename().string();
  if (!name.ends_with(".mrk.json"))
    throw InputError("cannot write landmarks as '" + name + "'; choose a name ending in .mrk.json");
  Json points = Json::array();
  for (const Landmark& landmark : landmarks.points) {
    if (!landmark.position.allFinite())
      throw InputError("landmark '" + landmark.name + "' has no finite position; place it again");
    points.push_back({{"id", std::to_string(points.size() + 1)},
                      {"label", landmark.name},
                      {"description", ""},
                      {"associatedNodeID", ""},
                      {"position", {landmark.position.x(), landmark.position.y(), landmark.position.z()}},
                      {"orientation", {-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0}},
                      {"selected", true},
                      {"locked", false},
                      {"visibility", true},
                      {"positionStatus", "defined"}});
  }
  const Json markup{{"type", "Fiducial"},
                    {"coordinateSystem", "LPS"},
                    {"coordinateUnits", "mm"},
                    {"locked", false},
                    {"labelFormat", "%N-%d"},
                    {"lastUsedControlPointNumber", points.size()},
                    {"fixedNumberOfControlPoints", false},
                    {"controlPoints", points},
                    {"measurements", Json::array()}};
  Json json{{"@schema", kSchema}, {"markups", Json::array({markup})}};
  if (landmarks.frame != "LPS")
    json["falciform"] = {{"frame", landmarks.frame}};  // a scanner's own frame, for our reader
  writeJsonFile(file, json, overwrite);
}

}  // namespace falciform
