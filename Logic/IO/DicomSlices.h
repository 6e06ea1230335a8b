#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "Logic/IO/DicomHeader.h"
#include "Logic/IO/DicomSeries.h"

namespace falciform {

/// Decodes slices of a series, several at a time, and hands each to `take` with its number in series.slices,
/// its file's header and its stored values. `take` is called from several threads, for different slices.
/// Inside Logic/IO only. Throws InputError that names the series' code for damaged files.
void forEachDicomSlice(
    const DicomSeries& series, const std::vector<std::size_t>& numbers, const Progress& progress,
    const std::function<void(std::size_t, const DicomHeader&, const std::vector<std::int32_t>&)>& take);

/// All slices, by number.
[[nodiscard]] std::vector<std::size_t> allSlices(const DicomSeries& series);

/// Throws for a series with a refusal, and for a grid that cannot be; warnings of its geometry.
[[nodiscard]] std::vector<std::string> checkDicomGrid(const DicomSeries& series);

}  // namespace falciform
