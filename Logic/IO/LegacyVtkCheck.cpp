#include <algorithm>
#include <cstdint>
#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"

// VTK's reader trusts the counts of a legacy file: a wrong one makes it read cells outside its memory, ask
// for any amount of memory, or return points of 1e37 without a word. So the file is walked once before,
// section by section.

namespace falciform {

namespace {

class LegacyWalk {
 public:
  LegacyWalk(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  void check() {
    readHead();
    while (place_ == Place::Geometry) {
      const std::string section(word());
      if (section.empty())
        break;
      else if (section == "FIELD")
        walkField();
      else if (section == "METADATA")
        skipMetadata();
      else if (section == "POINTS")
        walkPoints();
      else if (isOneOf(section, {"VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS"}))
        walkCells(section);
      else if (section == "POINT_DATA" || section == "CELL_DATA")
        startAttributes(section);
      else
        refuse("after " + last_ + " stands no section name (a wrong count, or truncated)");
      last_ = section;
    }
    while (place_ == Place::Attributes) walkAttribute();
  }

 private:
  enum class Place { Geometry, Attributes, End };

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(name_ + " is not a sound VTK file: " + why + "; copy or export it again");
  }

  static bool isOneOf(std::string_view word, std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), word) != names.end();
  }

  std::string_view word() {
    std::string_view rest = bytes_.substr(at_);
    const std::string_view found = nextWord(rest);
    at_ = bytes_.size() - rest.size();
    return found;
  }

  std::string_view line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view found = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    return found;
  }

  std::size_t count(const char* what) {
    std::size_t value = 0;
    if (!parseNumber(word(), value)) refuse(std::string("the number of ") + what + " is missing");
    if (value > bytes_.size())
      refuse("it announces " + std::to_string(value) + " " + what + ", more than its " +
             std::to_string(bytes_.size()) + " bytes hold");
    return value;
  }

  void readHead() {
    std::string_view first = line();
    if (!first.starts_with("# vtk DataFile Version"))
      refuse("its first line is not '# vtk DataFile Version'");
    first.remove_prefix(std::string_view("# vtk DataFile Version").size());
    double version = 0;
    if (!parseNumber(nextWord(first), version)) refuse("its version is no number");
    offsetsForm_ = version >= 5;
    (void)line();
    const std::string_view coding = word();
    if (coding != "ASCII" && coding != "BINARY") refuse("its third line is neither ASCII nor BINARY");
    binary_ = coding == "BINARY";
    if (word() != "DATASET") refuse("it has no DATASET line");
    if (const std::string kind(word()); kind != "POLYDATA")
      throw InputError(name_ + " holds " + kind.substr(0, 30) +
                       ", no surface (POLYDATA); extract the surface and export that");
  }

  std::size_t bitsOf(std::string_view type) const {
    static const std::map<std::string_view, std::size_t> kBits{
        {"bit", 1},    {"unsigned_char", 8}, {"char", 8},       {"signed_char", 8},   {"unsigned_short", 16},
        {"short", 16}, {"unsigned_int", 32}, {"int", 32},       {"float", 32},        {"unsigned_long", 64},
        {"long", 64},  {"double", 64},       {"vtkIdType", 32}, {"vtktypeint64", 64}, {"vtktypeuint64", 64}};
    const auto found = kBits.find(type);
    if (found == kBits.end())
      refuse("it has an array of the unknown type '" + std::string(type.substr(0, 20)) + "'");
    return found->second;
  }

  void skipValues(std::size_t values, std::string_view type, const char* what) {
    if (type == "string") return skipStrings(values);
    const std::size_t bits = bitsOf(type);
    if (binary_) {
      (void)line();
      const std::size_t size = (values * bits + 7) / 8;
      if (size > bytes_.size() - at_) refuse(std::string("it ends before all its ") + what + " (truncated)");
      at_ += size;
    } else {
      for (double number = 0; values > 0; --values)
        if (!parseNumber(word(), number))
          refuse(std::string("its ") + what + " end too early or are no numbers (truncated)");
    }
  }

  void skipStrings(std::size_t values) {
    (void)line();
    for (; values > 0; --values) {
      if (!binary_) {
        (void)line();
        continue;
      }
      // The two highest bits tell how many bytes the length takes.
      if (at_ >= bytes_.size()) refuse("it ends within a text (truncated)");
      const auto first = static_cast<unsigned char>(bytes_[at_]);
      const std::size_t width = std::size_t{1} << (3 - (first >> 6));
      std::size_t length = first & 0x3F;
      for (std::size_t k = 1; k < width && at_ + k < bytes_.size(); ++k)
        length = length << 8 | static_cast<unsigned char>(bytes_[at_ + k]);
      if (width > bytes_.size() - at_ || length > bytes_.size() - at_ - width)
        refuse("it ends within a text (truncated)");
      at_ += width + length;
    }
  }

  void walkPoints() {
    points_ = count("points");
    const std::string type(word());
    skipValues(3 * points_, type, "points");
  }

  void walkCells(const std::string& section) {
    if (offsetsForm_) return walkOffsetCells();
    const std::size_t cells = count("cells"), size = count("cell entries");
    if (binary_) (void)line();
    if (binary_ && size > (bytes_.size() - at_) / 4) refuse("it ends before all its cells (truncated)");
    std::size_t read = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      if (read == size)
        refuse(section + " hold fewer than the announced " + std::to_string(cells) + " cells");
      const std::int64_t corners = cellEntry();
      if (corners < 0 || corners > static_cast<std::int64_t>(size - ++read))
        refuse("cell " + std::to_string(cell) + " of " + section + " has an impossible number of corners");
      for (std::int64_t k = 0; k < corners; ++k, ++read)
        if (const std::int64_t id = cellEntry(); id < 0 || id >= static_cast<std::int64_t>(points_))
          refuse("cell " + std::to_string(cell) + " of " + section + " names point " + std::to_string(id) +
                 " of " + std::to_string(points_));
    }
    if (read != size) refuse(section + " hold more entries than their cells");
  }

  std::int64_t cellEntry() {
    if (!binary_) {
      std::int64_t value = 0;
      if (!parseNumber(word(), value)) refuse("its cells end too early or are no numbers (truncated)");
      return value;
    }
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes_[at_++]);
    return static_cast<std::int32_t>(value);
  }

  /// The form of version 5; the offsets themselves are checked in fromVtk.
  void walkOffsetCells() {
    const std::size_t offsets = count("cell offsets"), ids = count("cell entries");
    for (const auto& [keyword, values] : {std::pair("OFFSETS", offsets), std::pair("CONNECTIVITY", ids)}) {
      if (offsets == 0) break;
      if (word() != keyword) refuse(std::string("its cells have no ") + keyword);
      const std::string type(word());
      skipValues(values, type, "cells");
    }
  }

  void walkField() {
    (void)word();
    for (std::size_t arrays = count("field arrays"); arrays > 0; --arrays) {
      std::string_view arrayName = word();
      if (arrayName == "METADATA") {
        skipMetadata();
        arrayName = word();
      }
      const std::size_t width = count("components"), rows = count("values");
      const std::string type(word());
      if (rows > 0 && width > bytes_.size() / rows) refuse("a field array is larger than the file");
      skipValues(width * rows, type, "field values");
    }
  }

  void skipMetadata() {
    (void)line();
    while (at_ < bytes_.size() && line().find_first_not_of(" \r") != std::string_view::npos) {
    }
  }

  void startAttributes(const std::string& section) {
    tuples_ = count("attribute values");
    if (section == "POINT_DATA" && tuples_ != points_)
      refuse("its POINT_DATA has " + std::to_string(tuples_) + " values for " + std::to_string(points_) +
             " points");
    place_ = Place::Attributes;
  }

  void walkAttribute() {
    const std::string kind(word());
    if (kind.empty()) {
      place_ = Place::End;
      return;
    }
    if (kind == "POINT_DATA" || kind == "CELL_DATA") return startAttributes(kind);
    if (kind == "METADATA") return skipMetadata();
    if (kind == "FIELD") return walkField();
    (void)word();  // the array's name
    if (kind == "LOOKUP_TABLE")
      return skipValues(4 * count("table entries"), binary_ ? "unsigned_char" : "float", "table");
    if (kind == "COLOR_SCALARS")
      return skipValues(count("components") * tuples_, binary_ ? "unsigned_char" : "float", "colours");
    std::size_t width = 0;
    if (kind == "TEXTURE_COORDINATES") width = count("components");
    const std::string type(word());
    if (kind == "SCALARS") return walkScalars(type);
    if (isOneOf(kind, {"VECTORS", "NORMALS"}))
      width = 3;
    else if (kind == "TENSORS")
      width = 9;
    else if (isOneOf(kind, {"GLOBAL_IDS", "PEDIGREE_IDS", "EDGE_FLAGS"}))
      width = 1;
    else if (width == 0)
      refuse("it has an unknown attribute '" + kind.substr(0, 20) + "' (a wrong count, or damaged)");
    skipValues(width * tuples_, type, "attribute values");
  }

  void walkScalars(const std::string& type) {
    std::size_t width = 1;
    std::string_view rest = line();
    if (const std::string_view given = nextWord(rest);
        !given.empty() && (!parseNumber(given, width) || width > 1000))
      refuse("SCALARS have an impossible number of components");
    const std::size_t before = at_;
    if (word() == "LOOKUP_TABLE")
      (void)word();
    else
      at_ = before;
    // skipValues drops the rest of the line that named the array; here that line may be gone already.
    if (at_ == before) --at_;
    skipValues(width * tuples_, type, "scalars");
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0, points_ = 0, tuples_ = 0;
  bool binary_ = false, offsetsForm_ = false;
  Place place_ = Place::Geometry;
  std::string last_ = "the head";
};

}  // namespace

void checkLegacyVtk(const std::string& bytes, const std::string& name) { LegacyWalk(bytes, name).check(); }

}  // namespace falciform
