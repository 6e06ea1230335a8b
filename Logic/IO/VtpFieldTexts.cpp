#include "Logic/IO/VtpFieldTexts.h"

#include <algorithm>

#include "Logic/IO/VtpBlocks.h"

namespace falciform {

namespace {

std::string_view from(std::string_view text, std::string_view what) {
  return text.substr(std::min(text.find(what), text.size()));
}

std::string_view fieldData(std::string_view xml) {
  const std::string_view field = from(xml, "<FieldData");
  const std::size_t end = field.find("</FieldData>");
  return end == std::string_view::npos ? std::string_view{} : field.substr(0, end + 12);
}

std::vector<std::string> splitAtZeros(const std::string& bytes) {
  std::vector<std::string> texts;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\0', begin), bytes.size());
    texts.push_back(bytes.substr(begin, end - begin));
    begin = end + 1;
  }
  return texts;
}

void blank(std::string& file, std::size_t begin, std::size_t end) {
  std::fill(file.begin() + static_cast<std::ptrdiff_t>(begin),
            file.begin() + static_cast<std::ptrdiff_t>(end), ' ');
}

}  // namespace

VtpFieldTexts takeFieldTexts(std::string file) {
  VtpFieldTexts result;
  const VtpBlocks blocks(file);
  const std::size_t xmlEnd = blocks.xml().size();
  const std::string_view field = fieldData(blocks.xml());
  // <Array> is for texts only; numbers stand in <DataArray>.
  for (std::string_view rest = from(field, "<Array "); !rest.empty();
       rest = from(rest.substr(1), "<Array ")) {
    const std::string_view tag = rest.substr(0, rest.find('>'));
    const std::string_view inside = rest.substr(std::min(tag.size() + 1, rest.size()));
    if (const auto bytes = blocks.bytesOf(tag, inside.substr(0, inside.find('<'))))
      result.texts[std::string(xmlAttribute(tag, "Name"))] = splitAtZeros(*bytes);
  }
  if (!field.empty()) {
    const auto begin = static_cast<std::size_t>(field.data() - file.data());
    blank(file, begin, begin + field.size());
  }
  // Texts of points or cells are of no use here.
  for (std::size_t at = file.find("<Array "); at < xmlEnd; at = file.find("<Array ", at)) {
    const std::size_t tagEnd = std::min(file.find('>', at), xmlEnd - 1);
    const std::size_t close =
        file[tagEnd - 1] == '/' ? tagEnd + 1 : std::min(file.find("</Array>", tagEnd) + 8, xmlEnd);
    blank(file, at, std::max(close, tagEnd + 1));
  }
  result.fileWithout = std::move(file);
  return result;
}

}  // namespace falciform
