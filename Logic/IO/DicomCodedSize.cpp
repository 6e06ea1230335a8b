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

/// From the scan's data on: stuffed bytes, restarts and the end of image, nothing else (ISO 10918-1,
/// B.1.1.5).
void checkEntropyCoded(DicomBytes s, std::size_t at) {
  for (; at + 1 < s.size(); ++at) {
    if (s[at] != 0xFF) continue;
    const unsigned next = s[at + 1];
    if (next == 0xD9) return;
    if (next != 0 && next != 0xFF && (next < 0xD0 || next > 0xD7)) refuse("JPEG");
  }
  refuse("JPEG");  // no end: the stream is cut off
}

/// The header of the one scan: one component with two tables, and what the process allows (B.2.3).
void checkScan(DicomBytes s, std::size_t at, std::size_t length, const CodedSize& size, unsigned component) {
  if (size.process == 0 || length != 8 || s[at + 4] != 1 || s[at + 5] != component) refuse("JPEG");
  const unsigned from = s[at + 7], to = s[at + 8], shift = s[at + 9];
  const bool lossless = size.process == 0xC3;
  if (lossless ? from < 1 || from > 7 || to != 0 || shift > 15 : from != 0 || to != 63 || shift != 0)
    refuse("JPEG");
  checkEntropyCoded(s, at + 2 + length);
}

/// ISO 10918-1, annex B: start, tables and one frame header, one scan, end. The decoder in GDCM ends the
/// program where it meets anything else.
CodedSize sizeOfJpeg(DicomBytes s) {
  if (s.size() < 4 || s[0] != 0xFF || s[1] != 0xD8) refuse("JPEG");
  CodedSize size;
  unsigned component = 0;
  for (std::size_t at = 2; at + 4 <= s.size();) {
    const unsigned marker = s[at + 1];
    const std::size_t length = bigEndian(s, at + 2, 2);
    if (s[at] != 0xFF || length < 2 || length > s.size() - at - 2) refuse("JPEG");
    if (marker == 0xDA) {
      if (at + 10 > s.size()) refuse("JPEG");
      checkScan(s, at, length, size, component);
      return size;
    }
    const bool frame = marker == 0xC0 || marker == 0xC1 || marker == 0xC3;
    const bool tables =
        marker == 0xC4 || marker == 0xDB || marker == 0xDD || marker == 0xFE || (marker & 0xF0) == 0xE0;
    if ((!frame && !tables) || (frame && (length != 11 || size.process != 0))) refuse("JPEG");
    if (frame) {
      size = {bigEndian(s, at + 5, 2), bigEndian(s, at + 7, 2), s[at + 4], s[at + 9],
              static_cast<int>(marker)};
      component = s[at + 10];
      if (s[at + 11] != 0x11) refuse("JPEG");  // subsampled
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
