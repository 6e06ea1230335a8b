#pragma once
#include <gdcmTransferSyntax.h>

#include "Testing/Logic/IO/DicomBytes.h"

namespace falciform::test {

/// A 16 x 12 slice of `stored` bits with an uneven pattern.
[[nodiscard]] SlicePlan patternedSlice(int stored);

/// The same pixels packed by GDCM.
[[nodiscard]] SlicePlan packedSlice(SlicePlan plan, gdcm::TransferSyntax::TSType syntax);

}  // namespace falciform::test
