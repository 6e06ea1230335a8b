#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace falciform {

/// The value of name="value" in an XML tag; empty if it is not there.
[[nodiscard]] std::string_view xmlAttribute(std::string_view tag, std::string_view name);

/// The coded blocks of a VTK XML file (inline or appended; base64 or raw; deflated or not), read without VTK.
/// A view: the file must outlive it. Inside Logic/IO only.
class VtpBlocks {
 public:
  explicit VtpBlocks(std::string_view file);

  /// The part before the appended data.
  [[nodiscard]] std::string_view xml() const { return xml_; }
  /// False for compressors other than zlib.
  [[nodiscard]] bool readable() const { return readable_; }

  /// The bytes of an array given its tag and what stands between the tags; nothing if damaged or larger than
  /// 1 MB.
  [[nodiscard]] std::optional<std::string> bytesOf(std::string_view tag, std::string_view body) const;
  /// How many bytes the array's block says it holds; nothing if it cannot hold as many. Not for
  /// format="ascii".
  [[nodiscard]] std::optional<std::uint64_t> lengthOf(std::string_view tag, std::string_view body) const;

 private:
  struct Block {
    std::string_view text;
    bool base64 = true;
  };
  struct Deflated {
    std::uint64_t blocks = 0, size = 0, last = 0, length = 0;
    std::string header;
    std::string_view data;
  };

  [[nodiscard]] std::optional<Block> find(std::string_view tag, std::string_view body) const;
  [[nodiscard]] std::uint64_t number(const std::string& header, std::size_t index) const;
  [[nodiscard]] std::optional<Deflated> deflated(const Block& block) const;
  [[nodiscard]] std::optional<std::string> inflate(const Block& block) const;

  std::string_view xml_, appended_;
  bool readable_ = false, deflates_ = false, bigEndian_ = false, rawAppended_ = false;
  std::size_t word_ = 4;  ///< bytes of a number in a block's header
};

}  // namespace falciform
