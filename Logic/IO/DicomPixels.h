#pragma once
#include <cstdint>
#include <vector>

#include "Logic/IO/DicomHeader.h"

namespace falciform {

/// Throws InputError if the pixel data cannot hold `frames` frames of this format, before anything is
/// allocated for them, or if its compression is not known.
void checkPixelData(const DicomFile& file, const DicomPixelFormat& format, std::size_t frames);

/// The stored values of one frame, row by row, as numbers (sign extended; slope and intercept not applied).
/// Throws InputError for damaged data.
void decodeFrame(const DicomFile& file, const DicomPixelFormat& format, std::size_t frame, std::size_t frames,
                 std::vector<std::int32_t>& values);

}  // namespace falciform
