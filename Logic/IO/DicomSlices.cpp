#include "Logic/IO/DicomSlices.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/IO/DicomPixels.h"
#include "Logic/IO/VolumeLayout.h"

namespace falciform {

namespace {

constexpr std::size_t kFilesAtOnce = 16;

std::string nameOf(const DicomSeries& series) { return "DICOM series " + series.code; }

}  // namespace

std::vector<std::size_t> allSlices(const DicomSeries& series) {
  std::vector<std::size_t> numbers(series.slices.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

std::vector<std::string> checkDicomGrid(const DicomSeries& series) {
  if (!series.refusal.empty()) throw InputError(nameOf(series) + ": " + series.refusal);
  VolumeLayout layout;
  layout.file = nameOf(series);
  layout.size = checkedSize(layout.file, series.size.x(), series.size.y(), series.size.z());
  layout.worldFromIndex = series.worldFromIndex;
  checkGeometry(layout);
  std::vector<std::string> warnings = series.warnings;
  warnings.insert(warnings.end(), layout.warnings.begin(), layout.warnings.end());
  return warnings;
}

void forEachDicomSlice(
    const DicomSeries& series, const std::vector<std::size_t>& numbers, const Progress& progress,
    const std::function<void(std::size_t, const DicomHeader&, const std::vector<std::int32_t>&)>& take) {
  std::map<std::filesystem::path, std::vector<std::size_t>> byFile;
  for (const std::size_t number : numbers) byFile[series.slices[number].file].push_back(number);
  std::vector<const decltype(byFile)::value_type*> files;
  for (const auto& file : byFile) files.push_back(&file);
  const auto readFile = [&](const std::filesystem::path& path, const std::vector<std::size_t>& slices) {
    const DicomFile file = readDicomFile(path);
    const DicomHeader header = dicomHeader(file);
    if (header.format.columns != series.size.x() || header.format.rows != series.size.y())
      throw InputError("its files have changed; open it again");
    forEachChunk(slices.size(), 4, [&](std::size_t begin, std::size_t end) {
      std::vector<std::int32_t> values;
      for (std::size_t s = begin; s < end; ++s) {
        const std::size_t frame = series.slices[slices[s]].frame;
        if (frame >= header.frames.size()) throw InputError("its files have changed; open it again");
        decodeFrame(file, header.format, frame, header.frames.size(), values);
        take(slices[s], header, values);
      }
    });
  };
  try {
    for (std::size_t begin = 0; begin < files.size(); begin += kFilesAtOnce) {
      progress.report(static_cast<double>(begin) / static_cast<double>(files.size()), "Reading slices");
      forEachChunk(std::min(kFilesAtOnce, files.size() - begin), 1, [&](std::size_t from, std::size_t to) {
        for (std::size_t f = begin + from; f < begin + to; ++f) readFile(files[f]->first, files[f]->second);
      });
    }
  } catch (const InputError& error) {
    throw InputError("a file of " + nameOf(series) + ": " + error.what());
  }
  progress.report(1);
}

}  // namespace falciform
