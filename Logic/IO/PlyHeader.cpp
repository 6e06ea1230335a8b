#include "Logic/IO/PlyHeader.h"

#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

class HeaderReader {
 public:
  HeaderReader(const std::string& bytes, const std::string& name) : cursor_(bytes), length_(bytes.size()) {
    header_.name = name;
  }

  PlyHeader read() {
    std::string_view line;
    if (!cursor_.nextLine(line) || nextWord(line) != "ply") refuse("it does not begin with 'ply'");
    while (cursor_.nextLine(line)) {
      const std::string_view keyword = nextWord(line);
      if (keyword == "end_header") return finish();
      if (keyword == "comment" || keyword == "obj_info")
        addComment(line);
      else if (keyword == "format")
        setFormat(nextWord(line));
      else if (keyword == "element")
        addElement(line);
      else if (keyword == "property")
        addProperty(line);
      else if (!keyword.empty())
        refuse("its header has an unknown line '" + std::string(keyword.substr(0, 20)) + "'");
    }
    refuse("its header has no end_header");
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(header_.name + " is not a sound PLY file: " + why + "; export it again");
  }

  void addComment(std::string_view line) {
    header_.comments.emplace_back(line.substr(std::min(line.find_first_not_of(' '), line.size())));
  }

  void setFormat(std::string_view format) {
    if (format == "ascii")
      header_.format = PlyFormat::Ascii;
    else if (format == "binary_little_endian")
      header_.format = PlyFormat::LittleEndian;
    else if (format == "binary_big_endian")
      header_.format = PlyFormat::BigEndian;
    else
      refuse("its format '" + std::string(format.substr(0, 20)) + "' is unknown");
    formatSeen_ = true;
  }

  void addElement(std::string_view line) {
    PlyElement element;
    element.name = nextWord(line);
    if (!parseNumber(nextWord(line), element.count))
      refuse("element '" + element.name.substr(0, 20) + "' has no count");
    header_.elements.push_back(element);
  }

  void addProperty(std::string_view line) {
    if (header_.elements.empty()) refuse("a property stands before the first element");
    PlyProperty property;
    std::string_view type = nextWord(line);
    property.isList = type == "list";
    if (property.isList) {
      property.countType = typeOf(nextWord(line));
      type = nextWord(line);
    }
    property.type = typeOf(type);
    property.name = nextWord(line);
    header_.elements.back().properties.push_back(property);
  }

  PlyType typeOf(std::string_view word) const {
    static const std::map<std::string_view, PlyType> kTypes{
        {"char", PlyType::Int8},     {"int8", PlyType::Int8},     {"uchar", PlyType::UInt8},
        {"uint8", PlyType::UInt8},   {"short", PlyType::Int16},   {"int16", PlyType::Int16},
        {"ushort", PlyType::UInt16}, {"uint16", PlyType::UInt16}, {"int", PlyType::Int32},
        {"int32", PlyType::Int32},   {"uint", PlyType::UInt32},   {"uint32", PlyType::UInt32},
        {"float", PlyType::Float},   {"float32", PlyType::Float}, {"double", PlyType::Double},
        {"float64", PlyType::Double}};
    const auto found = kTypes.find(word);
    if (found == kTypes.end())
      refuse("a property has the unknown type '" + std::string(word.substr(0, 20)) + "'");
    return found->second;
  }

  /// Every value takes at least one byte, so no count can be larger than what is left.
  PlyHeader finish() {
    if (!formatSeen_) refuse("its header has no format line");
    header_.bodyBegin = cursor_.position();
    std::size_t left = length_ - header_.bodyBegin;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.count > left / element.properties.size())
        refuse("it announces " + std::to_string(element.count) + " '" + element.name +
               "', but ends before them (truncated)");
      left -= element.count * element.properties.size();
    }
    return header_;
  }

  TextCursor cursor_;
  std::size_t length_;
  PlyHeader header_;
  bool formatSeen_ = false;
};

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float:
      return 4;
    case PlyType::Double:
      break;
  }
  return 8;
}

PlyHeader readPlyHeader(const std::string& bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace falciform
