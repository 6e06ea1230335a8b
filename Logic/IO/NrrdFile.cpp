#include "Logic/IO/NrrdFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "Logic/IO/ByteReader.h"
#include "Logic/IO/NrrdHeader.h"

namespace falciform {

namespace {

constexpr std::size_t kMostAxes = 16;  // NRRD_DIM_MAX

Scalar scalarOf(const NrrdHeader& header) {
  struct Names {
    Scalar scalar;
    std::array<std::string_view, 7> names;
  };
  // The list of the format's definition, "Type".
  static constexpr std::array<Names, 10> kTypes{{
      {Scalar::Int8, {"signed char", "int8", "int8_t"}},
      {Scalar::UInt8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {Scalar::Int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
      {Scalar::UInt16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {Scalar::Int32, {"int", "signed int", "int32", "int32_t"}},
      {Scalar::UInt32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {Scalar::Int64,
       {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64",
        "int64_t"}},
      {Scalar::UInt64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
      {Scalar::Float32, {"float"}},
      {Scalar::Float64, {"double"}},
  }};
  const std::string type = lowerCase(header.needed("type"));
  for (const Names& entry : kTypes)
    if (!type.empty() && std::find(entry.names.begin(), entry.names.end(), type) != entry.names.end())
      return entry.scalar;
  refuseVolume(header.file, "its type is " + inQuotes(type) +
                                "; convert it to whole or floating-point numbers of 8 to 64 bits");
}

/// Which anatomical direction each coordinate of the space counts, as a sign against LPS.
Vector3d lpsSigns(VolumeLayout& layout, const NrrdHeader& header) {
  const std::string* given = header.field("space");
  const std::string space = given ? lowerCase(*given) : "";
  if (space == "left-posterior-superior" || space == "lps") return {1, 1, 1};
  if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
  if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
  if (space.ends_with("-time") || space == "rast" || space == "last" || space == "lpst")
    refuseVolume(layout.file,
                 "its space is " + inQuotes(space) + ": a time series; take one volume out and give that");
  const std::string* dimension = header.field("spacedimension");
  if (dimension && toWhole(*dimension) != 3)
    refuseVolume(layout.file,
                 "its space dimension is " + inQuotes(*dimension) + "; give a volume with three");
  if (given && space != "scanner-xyz" && space != "3d-right-handed" && space != "3d-left-handed")
    refuseVolume(layout.file,
                 "its space is " + inQuotes(*given) +
                     "; use left-posterior-superior or right-anterior-superior: correct the header");
  layout.warnings.push_back("the header does not say which way its axes point in the patient" +
                            (given ? " (space " + inQuotes(*given) + ")" : std::string()) + "; LPS assumed");
  return {1, 1, 1};
}

double mmOf(VolumeLayout& layout, const std::string& unit) {
  if (const auto mm = mmOfUnit(unit)) return *mm;
  if (!unit.empty())
    layout.warnings.push_back("the header's unit of length is " + inQuotes(unit) + "; mm assumed");
  return 1;
}

/// The axes that lie in space, out of all. The others must have one entry.
std::vector<std::size_t> spatialAxes(const NrrdHeader& header, const std::vector<std::int64_t>& sizes,
                                     const std::vector<bool>& inSpace) {
  std::vector<std::size_t> axes;
  const std::string* kinds = header.field("kinds");
  const std::vector<std::string_view> kind = kinds ? words(*kinds) : std::vector<std::string_view>();
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    if (inSpace[a]) {
      axes.push_back(a);
    } else if (sizes[a] != 1) {
      const std::string count = std::to_string(sizes[a]), name = a < kind.size() ? lowerCase(kind[a]) : "";
      if (header.keys.contains("Segment0_ID") || header.keys.contains("Segment0_LabelValue"))
        refuseVolume(header.file, "its segments overlap and stand in " + count +
                                      " layers; save each layer as a label map of its own");
      if (name == "time")
        refuseVolume(header.file, "it is a time series of " + count + " volumes; take one out and give that");
      refuseVolume(header.file,
                   "it holds " + count + " values a voxel (colours or vectors); give a volume with one");
    }
  }
  if (axes.size() != 3)
    refuseVolume(header.file,
                 "it has " + std::to_string(axes.size()) + " axes in space; give a volume with three");
  return axes;
}

void placeByDirections(VolumeLayout& layout, const NrrdHeader& header,
                       const std::vector<std::int64_t>& sizes) {
  Vector3d scale = lpsSigns(layout, header);
  const auto directions = nrrdVectors(header, "spacedirections");
  if (directions.size() != sizes.size())
    refuseVolume(layout.file, "its header has " + std::to_string(directions.size()) +
                                  " space directions for " + std::to_string(sizes.size()) +
                                  " axes; correct the header");
  std::vector<bool> inSpace;
  for (const auto& direction : directions) inSpace.push_back(direction.has_value());
  const std::vector<std::size_t> axes = spatialAxes(header, sizes, inSpace);
  layout.size = checkedSize(layout.file, sizes[axes[0]], sizes[axes[1]], sizes[axes[2]]);

  if (const std::string* units = header.field("spaceunits")) {
    const std::vector<std::string> names = nrrdTexts(*units);
    for (std::size_t d = 0; d < 3 && d < names.size(); ++d)
      scale(static_cast<Index>(d)) *= mmOf(layout, names[d]);
  }
  Matrix4d m = Matrix4d::Identity();
  for (std::size_t a = 0; a < 3; ++a) m.block<3, 1>(0, static_cast<Index>(a)) = *directions[axes[a]];
  if (header.field("spaceorigin")) {
    const auto origin = nrrdVectors(header, "spaceorigin");
    if (origin.size() != 1 || !origin[0])
      refuseVolume(layout.file, "its space origin is " + inQuotes(header.needed("spaceorigin")) +
                                    "; it must be one vector: correct the header");
    m.topRightCorner<3, 1>() = *origin[0];
  } else {
    layout.warnings.emplace_back("the header gives no space origin; the first voxel was put at 0");
  }
  layout.worldFromIndex = scale.homogeneous().asDiagonal() * m;
}

void placeBySpacings(VolumeLayout& layout, const NrrdHeader& header, const std::vector<std::int64_t>& sizes) {
  std::vector<double> spacings(sizes.size(), 1.0);
  const bool given = header.field("spacings") != nullptr;
  if (given) spacings = numbersOf(layout.file, "spacings", header.needed("spacings"), sizes.size());
  const std::string* kinds = header.field("kinds");
  const std::vector<std::string_view> kind = kinds ? words(*kinds) : std::vector<std::string_view>();
  std::vector<bool> inSpace;
  for (std::size_t a = 0; a < sizes.size(); ++a) {
    const std::string name = a < kind.size() ? lowerCase(kind[a]) : "";
    inSpace.push_back(sizes.size() == 3 || name == "domain" || name == "space" ||
                      (name.empty() && !std::isnan(spacings[a])));
  }
  const std::vector<std::size_t> axes = spatialAxes(header, sizes, inSpace);
  layout.size = checkedSize(layout.file, sizes[axes[0]], sizes[axes[1]], sizes[axes[2]]);
  const std::string* units = header.field("units");
  const std::vector<std::string> names = units ? nrrdTexts(*units) : std::vector<std::string>();
  for (std::size_t a = 0; a < 3; ++a) {
    const double mm = axes[a] < names.size() ? mmOf(layout, names[axes[a]]) : 1;
    layout.worldFromIndex(static_cast<Index>(a), static_cast<Index>(a)) = mm * spacings[axes[a]];
  }
  layout.warnings.push_back(std::string("the header gives ") + (given ? "spacings" : "sizes") +
                            " only, no orientation and no origin; axes taken as left, posterior, superior "
                            "with the first voxel at 0" +
                            (given ? "" : " and 1 mm apart"));
}

Packing packingOf(const NrrdHeader& header) {
  const std::string encoding = lowerCase(header.needed("encoding"));
  if (encoding == "raw") return Packing::Raw;
  if (encoding == "gzip" || encoding == "gz") return Packing::Deflated;
  if (encoding == "ascii" || encoding == "text" || encoding == "txt") return Packing::Text;
  refuseVolume(header.file, "its encoding is " + inQuotes(encoding) + "; save it with raw, gzip or ascii");
}

bool bigEndian(const NrrdHeader& header, const VolumeLayout& layout) {
  if (bytesOf(layout.scalar) == 1 || layout.packing == Packing::Text) return false;
  const std::string endian = lowerCase(header.needed("endian"));
  if (endian != "little" && endian != "big")
    refuseVolume(header.file,
                 "its endian is " + inQuotes(endian) + "; it must be little or big: correct the header");
  return endian == "big";
}

std::uint64_t endOfLines(const std::filesystem::path& file, std::uint64_t from, std::int64_t count) {
  ByteReader reader(file, from, Packing::Raw);
  char c = 0;
  while (count > 0 && reader.read(&c, 1) == 1) {
    ++from;
    if (c == '\n') --count;
  }
  return from;
}

/// "data file", "line skip" and "byte skip".
void locateVoxels(VolumeLayout& layout, const NrrdHeader& header) {
  layout.dataFile = layout.file;
  layout.fileOffset = header.end;
  if (const std::string* name = header.field("datafile")) {
    if (name->starts_with("LIST") || name->find('%') != std::string::npos)
      refuseVolume(layout.file,
                   "its voxels stand in several files (" + inQuotes(*name) + "); save it as one file");
    layout.dataFile = layout.file.parent_path() / *name;
    layout.fileOffset = 0;
  } else if (lowerCase(layout.file.extension().string()) == ".nhdr") {
    refuseVolume(layout.file, "its header names no data file; add 'data file: NAME'");
  }
  const auto skipOf = [&](const char* name, std::int64_t least) {
    const std::string* text = header.field(name);
    const std::int64_t skip = text ? wholesOf(layout.file, name, *text, 1)[0] : 0;
    if (skip < least || skip > (std::int64_t{1} << 40))
      refuseVolume(layout.file,
                   "its " + std::string(name) + " is " + std::to_string(skip) + "; correct the header");
    return skip;
  };
  if (const std::int64_t lines = skipOf("lineskip", 0))
    layout.fileOffset = endOfLines(layout.dataFile, layout.fileOffset, lines);
  const std::int64_t skip = skipOf("byteskip", -1);
  if (skip >= 0) {
    layout.streamOffset = static_cast<std::uint64_t>(skip);
    return;
  }
  // -1: the voxels are the file's last bytes.
  if (layout.packing != Packing::Raw)
    refuseVolume(layout.file, "its byte skip is -1, which goes with raw encoding only; correct the header");
  const std::uint64_t bytes =
      static_cast<std::uint64_t>(layout.size.cast<std::int64_t>().prod()) * bytesOf(layout.scalar);
  const std::uint64_t all = ByteReader(layout.dataFile, 0, Packing::Raw).mostBytes();
  layout.fileOffset = std::max(layout.fileOffset, all > bytes ? all - bytes : 0);
}

}  // namespace

VolumeLayout readNrrdLayout(const std::filesystem::path& file) {
  const NrrdHeader header = readNrrdHeader(file);
  VolumeLayout layout;
  layout.file = file;
  layout.scalar = scalarOf(header);
  layout.packing = packingOf(header);
  layout.bigEndian = bigEndian(header, layout);
  const std::int64_t dimension = wholesOf(file, "dimension", header.needed("dimension"), 1)[0];
  if (dimension < 3 || dimension > static_cast<std::int64_t>(kMostAxes))
    refuseVolume(file, "it has " + std::to_string(dimension) + " dimensions; give a volume with three");
  const auto sizes = wholesOf(file, "sizes", header.needed("sizes"), static_cast<std::size_t>(dimension));
  if (header.field("spacedirections"))
    placeByDirections(layout, header, sizes);
  else
    placeBySpacings(layout, header, sizes);
  locateVoxels(layout, header);
  checkGeometry(layout);
  return layout;
}

std::map<int, std::string> readNrrdSegmentNames(const std::filesystem::path& file) {
  const NrrdHeader header = readNrrdHeader(file);
  std::map<int, std::string> names;
  for (int segment = 0;; ++segment) {
    const std::string start = "Segment" + std::to_string(segment) + "_";
    const auto value = header.keys.find(start + "LabelValue"), name = header.keys.find(start + "Name");
    if (value == header.keys.end() || name == header.keys.end()) return names;
    if (const auto label = toWhole(value->second); label && *label > 0 && *label <= 65535)
      names[static_cast<int>(*label)] = name->second;
  }
}

}  // namespace falciform
