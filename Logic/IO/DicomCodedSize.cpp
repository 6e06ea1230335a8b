#include <string>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DicomCodecs.h"

namespace falciform {

namespace {

[[noreturn]] void refuse(const char* kind) {
  throw InputError(std::string("its ") + kind + " data is damaged; export or copy it again");
}

std::uint32_t bigEndian(DicomBytes stream, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t b = 0; b < count; ++b) value = value << 8 | stream[at + b];
  return value;
}

/// ISO 10918-1, B.2.2: the frame header SOFn comes before the scan.
CodedSize sizeOfJpeg(DicomBytes s) {
  if (s.size() < 4 || s[0] != 0xFF || s[1] != 0xD8) refuse("JPEG");
  for (std::size_t at = 2; at + 4 <= s.size();) {
    if (s[at] != 0xFF) refuse("JPEG");
    const unsigned marker = s[at + 1];
    if (marker == 0xFF) {  // fill
      ++at;
      continue;
    }
    const std::size_t length = bigEndian(s, at + 2, 2);
    if (length < 2 || length > s.size() - at - 2 || marker == 0xDA) refuse("JPEG");
    const bool isFrame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (isFrame) {
      if (length < 11) refuse("JPEG");
      CodedSize size{bigEndian(s, at + 5, 2), bigEndian(s, at + 7, 2), s[at + 4], s[at + 9]};
      if (size.components == 1 && s[at + 11] != 0x11) refuse("JPEG");  // subsampled
      return size;
    }
    at += 2 + length;
  }
  refuse("JPEG");
}

/// ISO 15444-1, A.5.1: SIZ is the first segment after the start of the code stream.
CodedSize sizeOfJpeg2000(DicomBytes s) {
  if (s.size() < 45 || bigEndian(s, 0, 4) != 0xFF4FFF51) refuse("JPEG 2000");
  const std::uint32_t right = bigEndian(s, 8, 4), bottom = bigEndian(s, 12, 4), left = bigEndian(s, 16, 4),
                      top = bigEndian(s, 20, 4);
  const std::uint32_t tileWidth = bigEndian(s, 24, 4), tileHeight = bigEndian(s, 28, 4);
  if (right <= left || bottom <= top || tileWidth == 0 || tileHeight == 0) refuse("JPEG 2000");
  CodedSize size{bottom - top, right - left, (s[42] & 0x7F) + 1, static_cast<int>(bigEndian(s, 40, 2))};
  const std::uint64_t tiles =
      (std::uint64_t{size.rows} / tileHeight + 2) * (std::uint64_t{size.columns} / tileWidth + 2);
  if (tiles > 4096 || s[43] != 1 || s[44] != 1) refuse("JPEG 2000");
  return size;
}

}  // namespace

CodedSize codedSize(DicomBytes stream, DicomCoding coding) {
  if (coding == DicomCoding::Jpeg2000) return sizeOfJpeg2000(stream);
  return sizeOfJpeg(stream);
}

}  // namespace falciform
