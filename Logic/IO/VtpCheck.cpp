#include <algorithm>
#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/VtpBlocks.h"

// VTK's reader asks for memory by the counts in the XML before it looks at the data: a wrong digit costs
// gigabytes. So each array's block is asked how much it holds first.

namespace falciform {

namespace {

std::uint64_t bytesOfType(std::string_view type) {
  static const std::map<std::string_view, std::uint64_t> kBytes{
      {"Int8", 1},   {"UInt8", 1},   {"Int16", 2}, {"UInt16", 2}, {"Int32", 4},
      {"UInt32", 4}, {"Float32", 4}, {"Int64", 8}, {"UInt64", 8}, {"Float64", 8}};
  const auto found = kBytes.find(type);
  return found == kBytes.end() ? 1 : found->second;
}

class VtpCheck {
 public:
  VtpCheck(std::string_view bytes, const std::string& name)
      : size_(bytes.size()), blocks_(bytes), name_(name) {}

  void check() {
    std::string_view rest = blocks_.xml();
    for (std::size_t at = rest.find('<'); at != std::string_view::npos; at = rest.find('<')) {
      rest.remove_prefix(at);
      const std::string_view tag = rest.substr(0, rest.find('>'));
      std::string_view words = tag.substr(1);
      const std::string_view element = nextWord(words);
      if (element == "Piece")
        startPiece(tag);
      else if (element == "DataArray")
        checkArray(tag, rest.substr(std::min(tag.size() + 1, rest.size())));
      else if (!element.starts_with('/') && !element.starts_with("InformationKey") &&
               !element.starts_with("Value"))
        section_ = element;
      rest.remove_prefix(1);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(name_ + " is damaged or truncated (" + why + "); copy or export it again");
  }

  void startPiece(std::string_view tag) {
    const auto count = [&](const char* key) {
      std::uint64_t value = 0;
      const std::string_view text = xmlAttribute(tag, key);
      // Packed at most 1032 to one, and at least a byte each.
      if (!text.empty() && (!parseNumber(text, value) || value > 1032 * size_))
        refuse(std::string(key) + " is " + inQuotes(text.substr(0, 20)) + ", more than the file can hold");
      return value;
    };
    counts_ = {{"Points", count("NumberOfPoints")}, {"Verts", count("NumberOfVerts")},
               {"Lines", count("NumberOfLines")},   {"Strips", count("NumberOfStrips")},
               {"Polys", count("NumberOfPolys")},   {"Cells", count("NumberOfCells")}};  // of .vtu
    counts_["PointData"] = counts_["Points"];
    counts_["CellData"] =
        counts_["Verts"] + counts_["Lines"] + counts_["Strips"] + counts_["Polys"] + counts_["Cells"];
  }

  void checkArray(std::string_view tag, std::string_view rest) const {
    const std::string_view name = xmlAttribute(tag, "Name");
    const auto count = counts_.find(section_);
    if (count == counts_.end()) return;
    std::uint64_t width = 1;
    const std::string_view components = xmlAttribute(tag, "NumberOfComponents");
    if (!components.empty() && (!parseNumber(components, width) || width > size_))
      refuse("array " + inQuotes(name.substr(0, 40)) + " has an impossible number of components");
    std::uint64_t values = count->second * width;
    const bool ids = name == "connectivity" && section_ != "PointData" && section_ != "CellData";
    if (ids) values = 0;  // as long as the last offset says, which VTK compares with the block itself
    const std::string_view body = rest.substr(0, rest.find('<'));
    if (xmlAttribute(tag, "format") == "ascii") {
      if (values > body.size())
        refuse("array " + inQuotes(name.substr(0, 40)) + " is shorter than announced");
      return;
    }
    if (!blocks_.readable() || count->second == 0) return;
    const auto length = blocks_.lengthOf(tag, body);
    if (!length) refuse("the block of array " + inQuotes(name.substr(0, 40)) + " cannot be right");
    if (values * bytesOfType(xmlAttribute(tag, "type")) > *length)
      refuse("array " + inQuotes(name.substr(0, 40)) + " is shorter than announced");
  }

  std::size_t size_;
  VtpBlocks blocks_;
  const std::string& name_;
  std::string_view section_;
  std::map<std::string_view, std::uint64_t> counts_;
};

}  // namespace

void checkVtp(const std::string& bytes, const std::string& name) { VtpCheck(bytes, name).check(); }

}  // namespace falciform
