#include <bit>
#include <cstring>
#include <map>
#include <numeric>

#include "Logic/Core/Errors.h"
#include "Logic/IO/Lzf.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/PcdHeader.h"
#include "Logic/IO/RangeGrid.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceParts.h"

namespace falciform {

namespace {

static_assert(std::endian::native == std::endian::little);  // as PCD's binary data are

template <class T>
T as(const char* raw) {
  T value;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

double numberAt(const char* raw, const PcdField& field) {
  if (field.type == 'F') return field.size == 4 ? double{as<float>(raw)} : as<double>(raw);
  const bool sign = field.type == 'I';
  switch (field.size) {
    case 1:
      return sign ? as<std::int8_t>(raw) : as<std::uint8_t>(raw);
    case 2:
      return sign ? as<std::int16_t>(raw) : as<std::uint16_t>(raw);
    case 4:
      return sign ? as<std::int32_t>(raw) : as<std::uint32_t>(raw);
    default:
      return sign ? static_cast<double>(as<std::int64_t>(raw)) : static_cast<double>(as<std::uint64_t>(raw));
  }
}

bool isColour(const PcdField& field) {
  return (field.name == "rgb" || field.name == "rgba") && field.size == 4 && field.count == 1;
}

/// The fields of one value, by name, N values each; colours apart, since their bits are what counts.
struct PcdColumns {
  std::map<std::string, VectorXd> numbers;
  std::vector<std::uint32_t> colours;  ///< 0xAARRGGBB
};

class PcdBody {
 public:
  PcdBody(const PcdHeader& header, std::string_view data, const std::string& name)
      : header_(header), data_(data), name_(name) {}

  PcdColumns read() {
    PcdColumns columns;
    for (const PcdField& field : header_.fields) {
      if (isColour(field)) columns.colours.resize(header_.points());
      if (!isColour(field) && field.count == 1)
        columns.numbers[field.name].resize(static_cast<Index>(header_.points()));
    }
    if (header_.coding == PcdCoding::Ascii)
      readText(columns);
    else
      readBinary(columns);
    return columns;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(name_ + ": " + why + "; copy or export it again");
  }

  void readText(PcdColumns& columns) {
    for (std::size_t i = 0; i < header_.points(); ++i)
      for (const PcdField& field : header_.fields)
        for (std::size_t k = 0; k < field.count; ++k) {
          const std::string_view word = nextWord(data_);
          double value = 0;
          if (word.empty()) refuse("it ends before all its points (truncated)");
          if (!parseNumber(word, value)) refuse("a word stands where a number should in its data");
          if (isColour(field))
            columns.colours[i] = field.type == 'F' ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
                                 : value >= 0 && value < 4294967296.0 ? static_cast<std::uint32_t>(value)
                                                                      : 0;
          else if (field.count == 1)
            columns.numbers[field.name][static_cast<Index>(i)] = value;
        }
  }

  /// Point after point, or, unpacked, field after field.
  void readBinary(PcdColumns& columns) {
    std::string unpacked;
    const bool byField = header_.coding == PcdCoding::Compressed;
    if (byField) {
      unpacked = unpack();
      data_ = unpacked;
    }
    std::size_t begin = 0;
    for (const PcdField& field : header_.fields) {
      const std::size_t width = field.size * field.count;
      const std::size_t step = byField ? width : header_.pointBytes();
      for (std::size_t i = 0; i < header_.points() && field.count == 1; ++i) {
        const char* raw = data_.data() + begin + i * step;
        if (isColour(field))
          columns.colours[i] = as<std::uint32_t>(raw);
        else
          columns.numbers[field.name][static_cast<Index>(i)] = numberAt(raw, field);
      }
      begin += byField ? width * header_.points() : width;
    }
  }

  std::string unpack() const {
    constexpr std::size_t kHead = 8;
    if (data_.size() < kHead) refuse("it ends before all its points (truncated)");
    const auto packed = as<std::uint32_t>(data_.data()), whole = as<std::uint32_t>(data_.data() + 4);
    if (whole != header_.points() * header_.pointBytes())
      refuse("its packed data are not as large as its header says");
    if (packed > data_.size() - kHead) refuse("it ends before all its points (truncated)");
    const auto result = unpackLzf(data_.substr(kHead, packed), whole);
    if (!result) refuse("its packed data are damaged");
    return *result;
  }

  const PcdHeader& header_;
  std::string_view data_;
  const std::string& name_;
};

bool takeRows(std::map<std::string, VectorXd>& numbers, const char* x, const char* y, const char* z,
              Points& rows) {
  if (!numbers.contains(x) || !numbers.contains(y) || !numbers.contains(z)) return false;
  rows.resize(numbers[x].size(), 3);
  rows << numbers[x], numbers[y], numbers[z];
  for (const char* name : {x, y, z}) numbers.erase(name);
  return true;
}

Colours unpackColours(const std::vector<std::uint32_t>& packed) {
  Colours colours(static_cast<Index>(packed.size()), 3);
  for (std::size_t i = 0; i < packed.size(); ++i)
    for (int k = 0; k < 3; ++k)
      colours(static_cast<Index>(i), k) = static_cast<std::uint8_t>(packed[i] >> (16 - 8 * k));
  return colours;
}

}  // namespace

RawSurface readPcd(const std::string& bytes, const std::string& name) {
  const PcdHeader header = readPcdHeader(bytes, name);
  PcdColumns columns = PcdBody(header, std::string_view(bytes).substr(header.bodyBegin), name).read();
  RawSurface raw;
  raw.space = header.space.empty() ? "scanner" : header.space;
  Surface& surface = raw.surface;
  if (!takeRows(columns.numbers, "x", "y", "z", surface.points))
    throw InputError(name + ": its points lack x, y or z; export it again");
  Points normals;
  const bool hasNormals = takeRows(columns.numbers, "normal_x", "normal_y", "normal_z", normals);
  if (!columns.colours.empty()) surface.colours = unpackColours(columns.colours);
  for (auto& [key, values] : columns.numbers)
    if (key != "_") surface.arrays[key] = std::move(values);

  RangeGrid grid{header.height, header.width, std::vector<int>(header.points())};
  std::iota(grid.point.begin(), grid.point.end(), 0);
  if (hasNormals) surface.normals = normals;
  (void)dropMissing(surface, grid);
  if (hasNormals) surface.normals = unitNormalsFrom(std::move(surface.normals));
  if (header.height > 1 && surface.size() > 0) joinRaster(surface, grid, header.viewpoint);
  return raw;
}

}  // namespace falciform
