#include "Logic/IO/DicomPixels.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DicomCodecs.h"

namespace falciform {

namespace {

using namespace dicomtag;

constexpr std::size_t kMostPixels = std::size_t{1} << 26;  ///< of one frame: 8192 x 8192

/// No coder packs more pixels into a byte than these; an empty 512 x 512 slice takes 80 bytes and more.
std::size_t mostPixelsPerByte(DicomCoding coding) { return coding == DicomCoding::RunLength ? 64 : 8192; }

[[noreturn]] void refuse(const std::string& what) { throw InputError(what + "; export or copy it again"); }

std::size_t pixelsOf(const DicomPixelFormat& format) {
  return static_cast<std::size_t>(format.rows) * static_cast<std::size_t>(format.columns);
}

std::uint32_t littleEndian(DicomBytes bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

/// The fragments of one frame: one each, or as the table of offsets has it (PS3.5, A.4).
std::vector<DicomBytes> fragmentsOf(const DicomElement& pixels, std::size_t frame, std::size_t frames) {
  const auto& all = pixels.fragments;
  if (all.size() < 2) refuse("its compressed pixel data is empty");
  const DicomBytes table = all.front();
  const std::size_t count = all.size() - 1;
  if (frames == 1) return {all.begin() + 1, all.end()};
  if (count == frames) return {all[frame + 1]};
  if (table.size() != 4 * frames)
    refuse("it does not say which of its compressed parts belong to which frame");
  const std::size_t begin = littleEndian(table, 4 * frame);
  const std::size_t end = frame + 1 < frames ? littleEndian(table, 4 * frame + 4) : std::size_t{1} << 40;
  std::vector<DicomBytes> own;
  std::size_t at = 0;
  for (std::size_t f = 1; f <= count; at += 8 + all[f++].size())
    if (at >= begin && at < end) own.push_back(all[f]);
  if (own.empty()) refuse("its table of frames is damaged");
  return own;
}

/// Bits that are stored, sign extended.
class Cut {
 public:
  explicit Cut(const DicomPixelFormat& format)
      : shift_(format.highBit + 1 - format.bitsStored),
        mask_(format.bitsStored == 32 ? 0xFFFFFFFFu : (1u << format.bitsStored) - 1),
        sign_(format.isSigned ? 1u << (format.bitsStored - 1) : 0) {}
  std::int32_t operator()(std::uint32_t raw) const {
    const std::uint32_t value = raw >> shift_ & mask_;
    return static_cast<std::int32_t>((value ^ sign_) - sign_);
  }

 private:
  int shift_;
  std::uint32_t mask_, sign_;
};

void takePlain(DicomBytes bytes, int bytesPerPixel, bool bigEndian, const Cut& cut,
               std::vector<std::int32_t>& values) {
  const auto step = static_cast<std::size_t>(bytesPerPixel);
  for (std::size_t p = 0; p < values.size(); ++p) {
    std::uint32_t raw = 0;
    for (std::size_t b = 0; b < step; ++b)
      raw |= std::uint32_t{bytes[p * step + b]} << 8 * (bigEndian ? step - 1 - b : b);
    values[p] = cut(raw);
  }
}

void takeBits(DicomBytes bytes, std::size_t first, std::vector<std::int32_t>& values) {
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = bytes[(first + p) / 8] >> (first + p) % 8 & 1;
}

const DicomElement& pixelData(const DicomFile& file) {
  const DicomElement* pixels = file.data.find(kPixelData);
  if (!pixels) refuse("it holds no image");
  return *pixels;
}

}  // namespace

void checkPixelData(const DicomFile& file, const DicomPixelFormat& format, std::size_t frames) {
  const DicomElement& pixels = pixelData(file);
  const DicomCoding coding = dicomCoding(format.transferSyntax);
  const std::size_t each = pixelsOf(format);
  if (each > kMostPixels) refuse("its slices have " + std::to_string(each) + " pixels, more than 2^26");
  if (coding == DicomCoding::None) {
    const auto bits = static_cast<std::size_t>(format.bitsAllocated);
    // A frame has at most 2^26 pixels, a file at most 2^20 frames: no overflow.
    const std::size_t need = (each * frames * bits + 7) / 8;
    if (pixels.value.size() < need)
      refuse("its pixels need " + std::to_string(need) + " bytes, " + std::to_string(pixels.value.size()) +
             " are there");
    return;
  }
  if (format.bitsAllocated == 1) refuse("its single bits are compressed");
  std::size_t packed = 0;
  for (const DicomBytes& fragment : pixels.fragments) packed += fragment.size();
  if (each * frames / mostPixelsPerByte(coding) > packed)
    refuse("its " + std::to_string(packed) +
           " compressed bytes cannot hold the pixels that its header gives");
}

void decodeFrame(const DicomFile& file, const DicomPixelFormat& format, std::size_t frame, std::size_t frames,
                 std::vector<std::int32_t>& values) {
  checkPixelData(file, format, frames);
  const DicomElement& pixels = pixelData(file);
  const DicomCoding coding = dicomCoding(format.transferSyntax);
  const std::size_t count = pixelsOf(format);
  values.resize(count);
  if (coding == DicomCoding::None) {
    if (format.bitsAllocated == 1) return takeBits(pixels.value, frame * count, values);
    const auto bytes = static_cast<std::size_t>(format.bitsAllocated / 8) * count;
    return takePlain(pixels.value.subspan(frame * bytes, bytes), format.bitsAllocated / 8, format.bigEndian,
                     Cut(format), values);
  }
  const auto parts = fragmentsOf(pixels, frame, frames);
  std::vector<unsigned char> joined;
  DicomBytes stream = parts.front();
  if (parts.size() > 1) {
    for (const DicomBytes& part : parts) joined.insert(joined.end(), part.begin(), part.end());
    stream = joined;
  }
  if (count / mostPixelsPerByte(coding) > stream.size())
    refuse("its compressed bytes cannot hold the pixels that its header gives");
  const DecodedPixels decoded = decodeCompressed(stream, coding, format);
  takePlain(decoded.bytes, decoded.bytesPerPixel, false, Cut(format), values);
}

}  // namespace falciform
