#include <array>
#include <cmath>
#include <cstring>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/PlyHeader.h"
#include "Logic/IO/RangeGrid.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceParts.h"

// VTK's reader drops the properties that it does not know (Patch), and trusts the counts of a damaged file.

namespace falciform {

namespace {

using Columns = std::map<std::string, VectorXd>;

/// The numbers after the header, one after the other, however they are stored.
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, const std::string& bytes)
      : name_(header.name), format_(header.format), rest_(std::string_view(bytes).substr(header.bodyBegin)) {}

  double next(PlyType type) { return format_ == PlyFormat::Ascii ? nextText() : nextBinary(type); }

  /// The length of a list; each of its entries takes at least a byte.
  std::size_t nextLength(const PlyProperty& property) {
    const double count = next(property.countType);
    if (!(count >= 0) || count != std::floor(count) || count > static_cast<double>(rest_.size()))
      throw InputError(name_ + ": a list of " + numberText(count) +
                       " entries does not fit in the file; export it again");
    return static_cast<std::size_t>(count);
  }

  void skip(const PlyProperty& property) {
    for (std::size_t left = property.isList ? nextLength(property) : 1; left > 0; --left)
      (void)next(property.type);
  }

 private:
  [[noreturn]] void refuseTruncated() const {
    throw InputError(name_ + ": the file ends before all its data (truncated); copy or export it again");
  }

  double nextText() {
    const std::string_view word = nextWord(rest_);
    double value = 0;
    if (word.empty()) refuseTruncated();
    if (!parseNumber(word, value))
      throw InputError(name_ + ": a word stands where a number should in the data; export it again");
    return value;
  }

  double nextBinary(PlyType type) {
    const std::size_t size = sizeOf(type);
    if (rest_.size() < size) refuseTruncated();
    char raw[8];
    for (std::size_t i = 0; i < size; ++i) raw[i] = rest_[format_ == PlyFormat::BigEndian ? size - 1 - i : i];
    rest_.remove_prefix(size);
    const auto as = [&raw]<class T>(T value) {
      std::memcpy(&value, raw, sizeof value);
      return static_cast<double>(value);
    };
    switch (type) {
      case PlyType::Int8:
        return as(std::int8_t{});
      case PlyType::UInt8:
        return as(std::uint8_t{});
      case PlyType::Int16:
        return as(std::int16_t{});
      case PlyType::UInt16:
        return as(std::uint16_t{});
      case PlyType::Int32:
        return as(std::int32_t{});
      case PlyType::UInt32:
        return as(std::uint32_t{});
      case PlyType::Float:
        return as(float{});
      case PlyType::Double:
        break;
    }
    return as(double{});
  }

  const std::string& name_;
  PlyFormat format_;
  std::string_view rest_;
};

/// The scalar properties by name; colours stored as floats in 0..1 are brought to 0..255.
Columns readColumns(PlyBody& body, const PlyElement& element) {
  Columns columns;
  std::vector<VectorXd*> targets;
  for (const PlyProperty& property : element.properties) {
    targets.push_back(property.isList ? nullptr : &columns[property.name]);
    if (targets.back()) targets.back()->resize(static_cast<Index>(element.count));
  }
  for (std::size_t i = 0; i < element.count; ++i)
    for (std::size_t k = 0; k < targets.size(); ++k)
      if (targets[k])
        (*targets[k])[static_cast<Index>(i)] = body.next(element.properties[k].type);
      else
        body.skip(element.properties[k]);
  for (const PlyProperty& property : element.properties)
    if ((property.type == PlyType::Float || property.type == PlyType::Double) && !property.isList)
      for (const char* colour : {"red", "green", "blue"})
        if (property.name == colour) columns[property.name] *= 255;
  return columns;
}

/// Moves three columns into rows; false if one is missing.
bool takeRows(Columns& columns, const std::array<std::string, 3>& names, Points& rows) {
  for (const std::string& name : names)
    if (!columns.contains(name)) return false;
  rows.resize(columns[names[0]].size(), 3);
  for (std::size_t k = 0; k < 3; ++k) rows.col(static_cast<Index>(k)) = columns[names[k]];
  for (const std::string& name : names) columns.erase(name);
  return true;
}

/// As MeshLab, Blender and VTK call them.
void takePlaces(Columns& columns, Surface& surface) {
  for (const auto& [u, v] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
    if (!columns.contains(u) || !columns.contains(v)) continue;
    surface.textureAt.resize(columns[u].size(), 2);
    surface.textureAt << columns[u].cast<float>(), columns[v].cast<float>();
    columns.erase(u);
    columns.erase(v);
    return;
  }
}

void takeVertices(Columns columns, const std::string& name, Surface& surface) {
  if (!takeRows(columns, {"x", "y", "z"}, surface.points))
    throw InputError(name + ": its vertices lack x, y or z; export it again");
  if (Points normals; takeRows(columns, {"nx", "ny", "nz"}, normals))
    surface.normals = unitNormalsFrom(std::move(normals));
  Points rgb;
  if (takeRows(columns, {"red", "green", "blue"}, rgb) ||
      takeRows(columns, {"diffuse_red", "diffuse_green", "diffuse_blue"}, rgb))
    surface.colours = coloursFrom(rgb);
  for (const char* patchName : {"Patch", "patch"})
    if (const auto labels = columns.find(patchName); labels != columns.end()) {
      surface.patch = patchLabelsFrom(labels->second, name);
      columns.erase(labels);
    }
  takePlaces(columns, surface);
  for (const char* unused : {"alpha", "diffuse_alpha"}) columns.erase(unused);
  surface.arrays = std::move(columns);  // such as CloudCompare's scalar_intensity
}

/// One corner after the other: MeshLab's "texcoord" lists two numbers for each.
void readFaces(PlyBody& body, const PlyElement& element, const std::string& name, RawSurface& raw) {
  TriangleCollector triangles(raw.surface.size(), name);
  TextureCollector corners;
  std::vector<long long> ids;
  std::vector<float> places;
  for (std::size_t i = 0; i < element.count; ++i) {
    ids.clear();
    places.clear();
    for (const PlyProperty& property : element.properties) {
      const bool isIds = property.name == "vertex_indices" || property.name == "vertex_index";
      if (!property.isList || (!isIds && property.name != "texcoord")) {
        body.skip(property);
        continue;
      }
      const std::size_t length = body.nextLength(property);
      for (std::size_t k = 0; k < length; ++k) {
        const double value = body.next(property.type);
        if (isIds)
          ids.push_back(value >= 0 && value < 4294967296.0 ? static_cast<long long>(value) : -1);
        else
          places.push_back(static_cast<float>(value));
      }
    }
    triangles.addPolygon(ids);
    for (std::size_t k = 0; places.size() == 2 * ids.size() && k < ids.size(); ++k)
      corners.put(ids[k], places[2 * k], places[2 * k + 1]);
  }
  raw.surface.triangles = triangles.triangles();
  corners.finish(raw.surface.size(), name, raw);
}

/// Stanford's range grid: a list of one point or none for each sample, the lowest line first; the scanner
/// looks down the z axis.
void readRangeGrid(PlyBody& body, const PlyElement& element, const PlyHeader& header, RawSurface& raw) {
  RangeGrid grid;
  for (const std::string& comment : header.comments) {
    std::string_view rest = comment;
    const std::string_view key = nextWord(rest);
    if (key == "num_cols") (void)parseNumber(nextWord(rest), grid.columns);
    if (key == "num_rows") (void)parseNumber(nextWord(rest), grid.rows);
  }
  if (grid.rows < 1 || grid.columns < 1 ||
      static_cast<double>(grid.rows) * grid.columns != static_cast<double>(element.count))
    throw InputError(header.name + ": obj_info says " + std::to_string(grid.rows) + " rows of " +
                     std::to_string(grid.columns) + " columns for a range_grid of " +
                     std::to_string(element.count) + " samples; mend num_rows and num_cols");
  for (std::size_t i = 0; i < element.count; ++i) {
    int point = -1;
    for (const PlyProperty& property : element.properties) {
      if (!property.isList) {
        body.skip(property);
        continue;
      }
      for (std::size_t left = body.nextLength(property); left > 0; --left) {
        const double value = body.next(property.type);
        if (!(value >= 0 && value < static_cast<double>(raw.surface.size())))
          throw InputError(header.name + ": the range grid names point " + numberText(value) +
                           ", but there are points 0 to " + std::to_string(raw.surface.size() - 1) +
                           "; export it again");
        point = static_cast<int>(value);
      }
    }
    grid.point.push_back(point);
  }
  constexpr double kFar = 1e6;
  joinRaster(raw.surface, grid, Vector3d(0, 0, kFar));
}

}  // namespace

RawSurface readPly(const std::string& bytes, const std::string& name) {
  const PlyHeader header = readPlyHeader(bytes, name);
  RawSurface raw;
  for (const std::string& comment : header.comments) {
    if (const auto tag = spaceTagIn(comment); tag && !raw.space) raw.space = tag;
    readPatchNameComment(comment, raw.surface);
    if (std::string_view rest = comment; nextWord(rest) == "TextureFile")
      raw.textureFile = rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
  }
  PlyBody body(header, bytes);
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex")
      takeVertices(readColumns(body, element), name, raw.surface);
    else if (element.name == "face")
      readFaces(body, element, name, raw);
    else if (element.name == "range_grid")
      readRangeGrid(body, element, header, raw);
    else if (!element.properties.empty())
      for (std::size_t i = 0; i < element.count; ++i)
        for (const PlyProperty& property : element.properties) body.skip(property);
  }
  return raw;
}

}  // namespace falciform
