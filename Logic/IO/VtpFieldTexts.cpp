#include "Logic/IO/VtpFieldTexts.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

constexpr std::size_t kLargest = 1 << 20;  // names, not data

/// The value of name="value" in the text of an XML tag; empty if it is not there.
std::string_view attribute(std::string_view tag, std::string_view name) {
  const std::string key = ' ' + std::string(name) + "=\"";
  const std::size_t begin = tag.find(key);
  if (begin == std::string_view::npos) return {};
  const std::string_view rest = tag.substr(begin + key.size());
  return rest.substr(0, rest.find('"'));
}

std::string_view between(std::string_view text, std::string_view open, std::string_view close) {
  const std::size_t begin = text.find(open);
  if (begin == std::string_view::npos) return {};
  const std::size_t end = text.find(close, begin);
  return end == std::string_view::npos ? std::string_view{} : text.substr(begin, end + close.size() - begin);
}

/// How the file codes its binary blocks.
struct Coding {
  bool base64 = true, compressed = false;
  std::size_t word = 4;  ///< bytes of a header number
};

/// A block's first `count` bytes, and what follows the part that held them.
std::optional<std::string> decode(std::string_view block, std::size_t count, const Coding& coding,
                                  std::string_view* rest = nullptr) {
  const std::size_t length = coding.base64 ? (count + 2) / 3 * 4 : count;
  if (count > kLargest || length > block.size()) return std::nullopt;
  if (rest) *rest = block.substr(length);
  if (!coding.base64) return std::string(block.substr(0, count));
  std::string bytes(length / 4 * 3, '\0');
  const auto* text = reinterpret_cast<const unsigned char*>(block.data());
  if (EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()), text, static_cast<int>(length)) < 0)
    return std::nullopt;
  bytes.resize(count);
  return bytes;
}

std::uint64_t headerNumber(const std::string& header, std::size_t index, const Coding& coding) {
  std::uint64_t value = 0;
  std::memcpy(&value, header.data() + index * coding.word, coding.word);
  return value;
}

/// Blocks of `size` bytes each but the last, deflated one by one: header {blocks, size, last size, deflated
/// sizes...}.
std::optional<std::string> inflateBlocks(std::string_view block, const Coding& coding) {
  auto header = decode(block, 3 * coding.word, coding);
  if (!header) return std::nullopt;
  const std::uint64_t blocks = headerNumber(*header, 0, coding), size = headerNumber(*header, 1, coding),
                      last = headerNumber(*header, 2, coding);
  if (blocks > 1000 || size > kLargest || last > size || blocks * size > kLargest) return std::nullopt;
  std::string_view data;
  header = decode(block, (3 + blocks) * coding.word, coding, &data);
  if (!header) return std::nullopt;
  std::uint64_t deflated = 0;
  for (std::uint64_t i = 0; i < blocks; ++i)
    deflated += std::min<std::uint64_t>(headerNumber(*header, 3 + i, coding), kLargest);
  const auto bytes = decode(data, deflated, coding);
  if (!bytes) return std::nullopt;
  std::string result;
  std::size_t at = 0;
  for (std::uint64_t i = 0; i < blocks; ++i) {
    const auto part = static_cast<uLong>(headerNumber(*header, 3 + i, coding));
    std::string text(i + 1 == blocks && last > 0 ? last : size, '\0');
    uLongf length = text.size();
    if (uncompress(reinterpret_cast<Bytef*>(text.data()), &length,
                   reinterpret_cast<const Bytef*>(bytes->data() + at), part) != Z_OK)
      return std::nullopt;
    result.append(text, 0, length);
    at += part;
  }
  return result;
}

std::optional<std::string> bytesOfBlock(std::string_view block, const Coding& coding) {
  if (coding.compressed) return inflateBlocks(block, coding);
  const auto header = decode(block, coding.word, coding);
  const std::uint64_t length = header ? headerNumber(*header, 0, coding) : 0;
  if (!header || length > kLargest) return std::nullopt;
  const auto bytes = decode(block, coding.word + length, coding);
  return bytes ? std::optional(bytes->substr(coding.word)) : std::nullopt;
}

/// format="ascii": the character codes as numbers.
std::string charactersFrom(std::string_view codes) {
  std::string text;
  int code = 0;
  for (std::string_view word = nextWord(codes); parseNumber(word, code); word = nextWord(codes))
    text += static_cast<char>(code);
  return text;
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

}  // namespace

VtpFieldTexts takeFieldTexts(std::string file) {
  VtpFieldTexts result;
  const std::size_t appendedAt = file.find("<AppendedData");
  const std::string_view xml = std::string_view(file).substr(0, appendedAt);
  const std::string_view appended =
      appendedAt == std::string::npos ? std::string_view{} : std::string_view(file).substr(appendedAt);
  const std::string_view root = between(xml, "<VTKFile", ">");
  const std::string_view compressor = attribute(root, "compressor");
  Coding coding;
  coding.compressed = compressor == "vtkZLibDataCompressor";
  coding.word = attribute(root, "header_type") == "UInt64" ? 8 : 4;
  const bool readable =
      attribute(root, "byte_order") != "BigEndian" && (coding.compressed || compressor.empty());
  const bool rawAppended = attribute(between(appended, "<AppendedData", ">"), "encoding") == "raw";
  const std::string_view blocks = appended.substr(std::min(appended.find('_'), appended.size()));

  const std::string_view field = between(xml, "<FieldData", "</FieldData>");
  std::string_view rest = field;
  while (readable && (rest = rest.substr(std::min(rest.find("<Array "), rest.size()))).size() > 1) {
    const std::string_view tag = rest.substr(0, rest.find('>'));
    const std::string_view inside = rest.substr(std::min(tag.size() + 1, rest.size()));
    const std::string_view body = inside.substr(0, inside.find('<'));
    const std::string_view format = attribute(tag, "format");
    std::size_t offset = 0;
    std::optional<std::string> bytes;
    coding.base64 = format != "appended" || !rawAppended;
    if (format == "ascii")
      bytes = charactersFrom(body);
    else if (format == "binary")
      bytes = bytesOfBlock(body.substr(std::min(body.find_first_not_of(" \t\r\n"), body.size())), coding);
    else if (parseNumber(attribute(tag, "offset"), offset) && offset + 1 < blocks.size())
      bytes = bytesOfBlock(blocks.substr(offset + 1), coding);
    if (bytes) result.texts[std::string(attribute(tag, "Name"))] = splitAtZeros(*bytes);
    rest.remove_prefix(1);
  }
  const std::size_t begin = field.empty() ? 0 : static_cast<std::size_t>(field.data() - file.data());
  std::fill_n(file.begin() + static_cast<std::ptrdiff_t>(begin), field.size(), ' ');
  // Texts a point or a cell are not of use here either; <Array> is for texts only, numbers stand in
  // <DataArray>.
  for (std::size_t at = file.find("<Array "); at < std::min(appendedAt, file.size());
       at = file.find("<Array ", at)) {
    const std::size_t tagEnd = std::min(file.find('>', at), file.size() - 1);
    std::size_t end = tagEnd;
    if (file[tagEnd - 1] != '/') end = std::min(file.find("</Array>", tagEnd), file.size() - 8) + 7;
    std::fill(file.begin() + static_cast<std::ptrdiff_t>(at),
              file.begin() + static_cast<std::ptrdiff_t>(end) + 1, ' ');
  }
  result.fileWithout = std::move(file);
  return result;
}

}  // namespace falciform
