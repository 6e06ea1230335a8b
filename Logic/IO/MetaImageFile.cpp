#include "Logic/IO/MetaImageFile.h"

#include <algorithm>
#include <map>
#include <optional>

#include "Logic/IO/ByteReader.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

/// "Key = Value" lines up to ElementDataFile, keys in lower case.
struct MetaHeader {
  std::filesystem::path file;
  std::map<std::string, std::string> fields;
  std::uint64_t end = 0;

  [[nodiscard]] const std::string* any(std::initializer_list<const char*> names) const {
    for (const char* name : names)
      if (const auto found = fields.find(name); found != fields.end()) return &found->second;
    return nullptr;
  }
  [[nodiscard]] const std::string& needed(const char* name) const {
    if (const std::string* value = any({name})) return *value;
    refuseVolume(file, "its header has no '" + std::string(name) + "'; it is damaged: export it again");
  }
  [[nodiscard]] bool flag(std::initializer_list<const char*> names) const {
    const std::string* value = any(names);
    return value && (value->starts_with('T') || value->starts_with('t') || *value == "1");
  }
};

bool isDataLine(std::string_view line) {
  return lowerCase(trimmed(line.substr(0, 40))).starts_with("elementdatafile");
}

MetaHeader readHeader(const std::filesystem::path& file) {
  const HeaderLines text = readHeaderLines(file, isDataLine);
  if (!text.complete)
    refuseVolume(
        file, "this is no MetaImage, or it is truncated: its header has no ElementDataFile; export it again");
  MetaHeader header;
  header.file = file;
  header.end = text.end;
  for (const std::string& line : text.lines) {
    const std::size_t separator = line.find_first_of("=:");
    if (separator == std::string::npos) {
      if (trimmed(line).empty()) continue;
      refuseVolume(file, "its header holds " + inQuotes(line) +
                             "; each line must read 'Key = Value': correct the header");
    }
    header.fields[lowerCase(trimmed(std::string_view(line).substr(0, separator)))] =
        trimmed(std::string_view(line).substr(separator + 1));
  }
  return header;
}

Scalar scalarOf(const MetaHeader& header) {
  static const std::map<std::string, Scalar> kTypes{{"MET_CHAR", Scalar::Int8},
                                                    {"MET_UCHAR", Scalar::UInt8},
                                                    {"MET_SHORT", Scalar::Int16},
                                                    {"MET_USHORT", Scalar::UInt16},
                                                    {"MET_INT", Scalar::Int32},
                                                    {"MET_UINT", Scalar::UInt32},
                                                    {"MET_LONG", Scalar::Int32},
                                                    {"MET_ULONG", Scalar::UInt32},  // 4 bytes in this format,
                                                                                    // whatever the machine
                                                    {"MET_LONG_LONG", Scalar::Int64},
                                                    {"MET_ULONG_LONG", Scalar::UInt64},
                                                    {"MET_FLOAT", Scalar::Float32},
                                                    {"MET_DOUBLE", Scalar::Float64}};
  const std::string& type = header.needed("elementtype");
  const auto found = kTypes.find(type);
  if (found == kTypes.end())
    refuseVolume(header.file, "its ElementType is " + inQuotes(type) +
                                  "; convert it to one number of 8 to 64 bits a voxel");
  const std::string* channels = header.any({"elementnumberofchannels"});
  if (channels && toWhole(*channels) != 1)
    refuseVolume(header.file, "it holds " + inQuotes(*channels) +
                                  " values a voxel (colours or vectors); give a volume with one");
  return found->second;
}

double mmOfHeader(VolumeLayout& layout, const MetaHeader& header) {
  const std::string* unit = header.any({"distanceunits"});
  if (!unit || *unit == "?") return 1;  // the format's default is mm
  if (const auto mm = mmOfUnit(*unit)) return *mm;
  layout.warnings.push_back("the header's unit of length is " + inQuotes(*unit) + "; mm assumed");
  return 1;
}

void place(VolumeLayout& layout, const MetaHeader& header) {
  const std::int64_t dimension = wholesOf(layout.file, "NDims", header.needed("ndims"), 1)[0];
  if (dimension < 3 || dimension > 4)
    refuseVolume(layout.file,
                 "it has " + std::to_string(dimension) + " dimensions; give a volume with three");
  const auto n = static_cast<std::size_t>(dimension);
  const auto sizes = wholesOf(layout.file, "DimSize", header.needed("dimsize"), n);
  if (n == 4 && sizes[3] != 1)
    refuseVolume(layout.file, "it is a time series of " + std::to_string(sizes[3]) +
                                  " volumes; take one out and give that");
  layout.size = checkedSize(layout.file, sizes[0], sizes[1], sizes[2]);

  std::vector<double> spacing(n, 1.0), origin(n, 0.0);
  if (const std::string* text = header.any({"elementspacing", "elementsize"}))
    spacing = numbersOf(layout.file, "ElementSpacing", *text, n);
  else
    layout.warnings.emplace_back("the header gives no ElementSpacing; 1 mm assumed");
  if (const std::string* text = header.any({"offset", "position", "origin"}))
    origin = numbersOf(layout.file, "Offset", *text, n);
  else
    layout.warnings.emplace_back("the header gives no Offset; the first voxel was put at 0");
  std::vector<double> rows(n * n, 0.0);
  if (const std::string* text = header.any({"transformmatrix", "rotation", "orientation"})) {
    rows = numbersOf(layout.file, "TransformMatrix", *text, n * n);
  } else {
    for (std::size_t d = 0; d < n; ++d) rows[d * n + d] = 1;
    layout.warnings.emplace_back(
        "the header gives no TransformMatrix; axes taken as left, posterior, superior");
  }
  const double mm = mmOfHeader(layout, header);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t d = 0; d < 3; ++d)
      layout.worldFromIndex(static_cast<Index>(d), static_cast<Index>(axis)) =
          mm * spacing[axis] * rows[axis * n + d];
  layout.worldFromIndex.topRightCorner<3, 1>() = mm * Vector3d(origin[0], origin[1], origin[2]);
}

void locateVoxels(VolumeLayout& layout, const MetaHeader& header) {
  const std::string& name = header.needed("elementdatafile");
  const bool local = name == "LOCAL" || name == "Local" || name == "local";
  if (!local && (name.starts_with("LIST") || name.find('%') != std::string::npos))
    refuseVolume(layout.file,
                 "its voxels stand in several files (" + inQuotes(name) + "); save it as one .mha file");
  if (name.empty())
    refuseVolume(layout.file, "its ElementDataFile is empty; write LOCAL or the name of the data file");
  layout.dataFile = local ? layout.file : layout.file.parent_path() / name;
  layout.fileOffset = local ? header.end : 0;
  const bool text = header.any({"binarydata"}) && !header.flag({"binarydata"});
  layout.packing = header.flag({"compresseddata"}) ? Packing::Deflated : text ? Packing::Text : Packing::Raw;
  const std::string* headerSize = header.any({"headersize"});
  if (!headerSize) return;
  const std::int64_t skip = wholesOf(layout.file, "HeaderSize", *headerSize, 1)[0];
  if (skip < -1 || skip > (std::int64_t{1} << 40) || (skip == -1 && layout.packing != Packing::Raw))
    refuseVolume(layout.file, "its HeaderSize is " + std::to_string(skip) + "; correct the header");
  if (skip > 0 && !local) layout.fileOffset = static_cast<std::uint64_t>(skip);
  if (skip != -1) return;
  // -1: the voxels are the file's last bytes.
  const std::uint64_t bytes =
      static_cast<std::uint64_t>(layout.size.cast<std::int64_t>().prod()) * bytesOf(layout.scalar);
  const std::uint64_t all = ByteReader(layout.dataFile, 0, Packing::Raw).mostBytes();
  layout.fileOffset = std::max(layout.fileOffset, all > bytes ? all - bytes : 0);
}

void readScale(VolumeLayout& layout, const MetaHeader& header) {
  if (const std::string* slope = header.any({"elementtointensityfunctionslope"}))
    layout.slope = numbersOf(layout.file, "ElementToIntensityFunctionSlope", *slope, 1)[0];
  if (const std::string* offset = header.any({"elementtointensityfunctionoffset"}))
    layout.intercept = numbersOf(layout.file, "ElementToIntensityFunctionOffset", *offset, 1)[0];
}

}  // namespace

VolumeLayout readMetaImageLayout(const std::filesystem::path& file) {
  const MetaHeader header = readHeader(file);
  VolumeLayout layout;
  layout.file = file;
  if (const std::string* type = header.any({"objecttype"}); type && *type != "Image")
    refuseVolume(file, "its ObjectType is " + inQuotes(*type) + "; give a file of an Image");
  layout.scalar = scalarOf(header);
  layout.bigEndian = header.flag({"binarydatabyteordermsb", "elementbyteordermsb"});
  place(layout, header);
  locateVoxels(layout, header);
  readScale(layout, header);
  checkGeometry(layout);
  return layout;
}

}  // namespace falciform
