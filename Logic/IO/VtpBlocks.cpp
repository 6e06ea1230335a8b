#include "Logic/IO/VtpBlocks.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>

#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

constexpr std::uint64_t kLargestText = 1 << 20;
constexpr std::uint64_t kLargestRatio = 1032;  ///< deflate cannot pack more bytes into one

/// The first `count` bytes of a block, and in `rest` what follows the part that held them.
std::optional<std::string> decode(std::string_view text, bool base64, std::uint64_t count,
                                  std::string_view* rest = nullptr) {
  if (count > text.size()) return std::nullopt;
  const std::size_t length = base64 ? (count + 2) / 3 * 4 : count;
  if (length > text.size()) return std::nullopt;
  if (rest) *rest = text.substr(length);
  if (!base64) return std::string(text.substr(0, count));
  std::string bytes(length / 4 * 3, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(text.data());
  if (EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()), from, static_cast<int>(length)) < 0)
    return std::nullopt;
  bytes.resize(count);
  return bytes;
}

/// format="ascii": the character codes as numbers.
std::string charactersFrom(std::string_view codes) {
  std::string text;
  int code = 0;
  for (std::string_view word = nextWord(codes); parseNumber(word, code); word = nextWord(codes))
    text += static_cast<char>(code);
  return text;
}

}  // namespace

std::string_view xmlAttribute(std::string_view tag, std::string_view name) {
  const std::string key = ' ' + std::string(name) + "=\"";
  const std::size_t begin = tag.find(key);
  if (begin == std::string_view::npos) return {};
  const std::string_view rest = tag.substr(begin + key.size());
  return rest.substr(0, rest.find('"'));
}

VtpBlocks::VtpBlocks(std::string_view file) {
  const std::size_t at = std::min(file.find("<AppendedData"), file.size());
  xml_ = file.substr(0, at);
  const std::string_view appended = file.substr(at);
  rawAppended_ = xmlAttribute(appended.substr(0, appended.find('>')), "encoding") == "raw";
  // VTK takes whatever comes first for the data if it is no underscore; we then take none.
  const std::size_t inside = std::min(appended.find('>'), appended.size());
  const std::size_t begin = appended.find_first_not_of("> \t\r\n\v\f", inside);
  if (begin != std::string_view::npos && appended[begin] == '_') appended_ = appended.substr(begin);
  const std::string_view root = xml_.substr(std::min(xml_.find("<VTKFile"), xml_.size()));
  const std::string_view tag = root.substr(0, root.find('>'));
  const std::string_view compressor = xmlAttribute(tag, "compressor");
  deflates_ = compressor == "vtkZLibDataCompressor";
  readable_ = deflates_ || compressor.empty();
  bigEndian_ = xmlAttribute(tag, "byte_order") == "BigEndian";
  word_ = xmlAttribute(tag, "header_type") == "UInt64" ? 8 : 4;
}

std::optional<VtpBlocks::Block> VtpBlocks::find(std::string_view tag, std::string_view body) const {
  if (!readable_) return std::nullopt;
  if (xmlAttribute(tag, "format") != "appended")
    return Block{body.substr(std::min(body.find_first_not_of(" \t\r\n"), body.size())), true};
  std::size_t offset = 0;
  if (!parseNumber(xmlAttribute(tag, "offset"), offset) || appended_.empty() ||
      offset >= appended_.size() - 1)
    return std::nullopt;
  return Block{appended_.substr(offset + 1), !rawAppended_};
}

std::uint64_t VtpBlocks::number(const std::string& header, std::size_t index) const {
  std::uint64_t value = 0;
  for (std::size_t k = 0; k < word_; ++k)
    value = value << 8 | static_cast<unsigned char>(header[index * word_ + (bigEndian_ ? k : word_ - 1 - k)]);
  return value;
}

/// Blocks of `size` bytes each but the last, deflated one by one: header {blocks, size, last size, deflated
/// sizes...}.
std::optional<VtpBlocks::Deflated> VtpBlocks::deflated(const Block& block) const {
  Deflated result;
  auto header = decode(block.text, block.base64, word_);
  if (!header) return std::nullopt;
  if (number(*header, 0) == 0) return result;
  header = decode(block.text, block.base64, 3 * word_);
  if (!header) return std::nullopt;
  result.blocks = number(*header, 0);
  result.size = number(*header, 1);
  result.last = number(*header, 2);
  if (result.blocks > block.text.size() || result.size > kLargestRatio * block.text.size() ||
      result.last > result.size)
    return std::nullopt;
  header = decode(block.text, block.base64, (3 + result.blocks) * word_, &result.data);
  if (!header) return std::nullopt;
  std::uint64_t packed = 0;
  for (std::uint64_t i = 0; i < result.blocks; ++i) {
    const std::uint64_t part = number(*header, 3 + i);
    const std::uint64_t whole = i + 1 == result.blocks && result.last > 0 ? result.last : result.size;
    if (part > result.data.size() || whole > kLargestRatio * part) return std::nullopt;
    packed += part;
    result.length += whole;
  }
  if (packed > result.data.size()) return std::nullopt;
  result.header = std::move(*header);
  return result;
}

std::optional<std::string> VtpBlocks::inflate(const Block& block) const {
  const auto parts = deflated(block);
  if (!parts || parts->length > kLargestText) return std::nullopt;
  std::uint64_t packed = 0;
  for (std::uint64_t i = 0; i < parts->blocks; ++i) packed += number(parts->header, 3 + i);
  const auto bytes = decode(parts->data, block.base64, packed);
  if (!bytes) return std::nullopt;
  std::string result;
  std::size_t at = 0;
  for (std::uint64_t i = 0; i < parts->blocks; ++i) {
    const auto part = static_cast<uLong>(number(parts->header, 3 + i));
    std::string text(i + 1 == parts->blocks && parts->last > 0 ? parts->last : parts->size, '\0');
    uLongf length = text.size();
    if (uncompress(reinterpret_cast<Bytef*>(text.data()), &length,
                   reinterpret_cast<const Bytef*>(bytes->data() + at), part) != Z_OK)
      return std::nullopt;
    result.append(text, 0, length);
    at += part;
  }
  return result;
}

std::optional<std::string> VtpBlocks::bytesOf(std::string_view tag, std::string_view body) const {
  if (xmlAttribute(tag, "format") == "ascii") return charactersFrom(body);
  const auto block = find(tag, body);
  if (!block) return std::nullopt;
  if (deflates_) return inflate(*block);
  const auto length = lengthOf(tag, body);
  if (!length || *length > kLargestText) return std::nullopt;
  const auto bytes = decode(block->text, block->base64, word_ + *length);
  return bytes ? std::optional(bytes->substr(word_)) : std::nullopt;
}

std::optional<std::uint64_t> VtpBlocks::lengthOf(std::string_view tag, std::string_view body) const {
  const auto block = find(tag, body);
  if (!block) return std::nullopt;
  if (deflates_) {
    const auto parts = deflated(*block);
    return parts ? std::optional(parts->length) : std::nullopt;
  }
  const auto header = decode(block->text, block->base64, word_);
  if (!header || number(*header, 0) > block->text.size()) return std::nullopt;
  return number(*header, 0);
}

}  // namespace falciform
