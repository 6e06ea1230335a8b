#pragma once
#include <vector>

#include "Logic/IO/DicomHeader.h"

namespace falciform {

// Compressed frames. Inside Logic/IO only.

enum class DicomCoding { None, RunLength, Jpeg, Jpeg2000 };

/// By transfer syntax; throws InputError for those that are not known.
[[nodiscard]] DicomCoding dicomCoding(const std::string& transferSyntax);

/// Bytes of one pixel of a decoded frame, and how many bits of them count.
struct DecodedPixels {
  std::vector<unsigned char> bytes;  ///< little endian, row by row
  int bytesPerPixel = 2;
};

/// One compressed frame. Its own header is held against `format` before the decoder sees it: as many rows,
/// columns and bits, one component, no subsampling. Throws InputError for anything else.
[[nodiscard]] DecodedPixels decodeCompressed(DicomBytes stream, DicomCoding coding,
                                             const DicomPixelFormat& format);

/// DICOM's run lengths (PS3.5, annex G).
[[nodiscard]] DecodedPixels decodeRunLength(DicomBytes stream, const DicomPixelFormat& format);

/// Rows, columns, bits and components of a JPEG or JPEG 2000 stream, from its header; throws
/// InputError where it is damaged.
struct CodedSize {
  std::uint32_t rows = 0, columns = 0;
  int bits = 0, components = 0;
  int process = 0;  ///< of a JPEG stream: its frame marker, 0xC3 is lossless
};
[[nodiscard]] CodedSize codedSize(DicomBytes stream, DicomCoding coding);

}  // namespace falciform
