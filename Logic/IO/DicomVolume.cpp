#include <algorithm>
#include <cmath>
#include <new>
#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DicomSeries.h"
#include "Logic/IO/DicomSlices.h"

namespace falciform {

namespace {

enum class Between { Linear, Nearest };

template <class T>
Volume<T> emptyVolume(const DicomSeries& series) {
  Volume<T> volume;
  volume.size = series.size;
  volume.worldFromIndex = series.worldFromIndex;
  try {
    volume.voxels.assign(volume.offset(0, 0, series.size.z()), T{});
  } catch (const std::bad_alloc&) {
    throw InputError("DICOM series " + series.code +
                     ": its voxels do not fit into memory; crop or resample it");
  }
  return volume;
}

/// The slices of `sources` (one after another, at series.slices[..].index) on the even grid.
void resample(const DicomSeries& series, const std::vector<float>& sources, Between between, Image& image) {
  const std::size_t each = image.offset(0, 0, 1);
  std::size_t below = 0;
  for (int k = 0; k < series.size.z(); ++k) {
    while (below + 2 < series.slices.size() && series.slices[below + 1].index <= k) ++below;
    const double low = series.slices[below].index, high = series.slices[below + 1].index;
    auto share = static_cast<float>(std::clamp((k - low) / (high - low), 0.0, 1.0));
    if (between == Between::Nearest) share = share > 0.5f ? 1 : 0;
    const float *a = &sources[below * each], *b = &sources[(below + 1) * each];
    float* to = &image.voxels[static_cast<std::size_t>(k) * each];
    for (std::size_t v = 0; v < each; ++v) to[v] = (1 - share) * a[v] + share * b[v];
  }
}

Loaded<Image> readValues(const DicomSeries& series, Between between, const Progress& progress) {
  Loaded<Image> loaded;
  loaded.warnings = checkDicomGrid(series);
  loaded.value = emptyVolume<float>(series);
  const std::size_t each = loaded.value.offset(0, 0, 1);
  std::vector<float> sources;
  if (series.resampled) sources.resize(each * series.slices.size());
  std::vector<float>& into = series.resampled ? sources : loaded.value.voxels;
  forEachDicomSlice(
      series, allSlices(series), progress,
      [&](std::size_t number, const DicomHeader& header, const std::vector<std::int32_t>& values) {
        const DicomFrame& frame = header.frames[series.slices[number].frame];
        float* to = &into[number * each];
        for (std::size_t v = 0; v < each; ++v)
          to[v] = static_cast<float>(frame.slope * values[v] + frame.intercept);
      });
  if (series.resampled) resample(series, sources, between, loaded.value);
  return loaded;
}

/// A label of each voxel of a segmentation: its frames hold one segment each, or labels.
Loaded<LabelMap> readSegments(const DicomSeries& series, const Progress& progress) {
  Loaded<LabelMap> loaded;
  loaded.warnings = checkDicomGrid(series);
  LabelMap& map = loaded.value = emptyVolume<std::uint16_t>(series);
  const std::size_t each = map.offset(0, 0, 1);
  std::size_t overlapping = 0;
  // In the order of the segments, so that an overlap's outcome does not depend on the file's order.
  std::set<int> segments;
  for (const DicomSlice& slice : series.slices) segments.insert(slice.segment);
  for (const int segment : segments) {
    if (segment < 0 || segment > 65535)
      throw InputError("DICOM series " + series.code + ": a segment's number is no label");
    std::vector<std::size_t> own;
    for (const std::size_t s : allSlices(series))
      if (series.slices[s].segment == segment) own.push_back(s);
    std::vector<std::size_t> overlaps(series.slices.size(), 0);
    std::vector<bool> used(static_cast<std::size_t>(series.size.z()), false);
    for (const std::size_t s : own) {
      const auto k = static_cast<std::size_t>(series.slices[s].index);
      if (used[k])
        throw InputError("DICOM series " + series.code +
                         ": two frames of one segment lie at the same place; export it again");
      used[k] = true;
    }
    forEachDicomSlice(
        series, own, progress,
        [&](std::size_t number, const DicomHeader& header, const std::vector<std::int32_t>& values) {
          const auto k = static_cast<std::size_t>(series.slices[number].index);
          std::uint16_t* to = &map.voxels[k * each];
          const int inside = header.fractional ? (header.maximumFraction + 1) / 2 : 1;
          for (std::size_t v = 0; v < each; ++v) {
            if (values[v] < inside || values[v] > 65535) continue;
            overlaps[number] += to[v] != 0;
            to[v] = static_cast<std::uint16_t>(header.labelMap ? values[v] : segment);
          }
        });
    for (const std::size_t count : overlaps) overlapping += count;
  }
  if (overlapping > 0)
    loaded.warnings.push_back(std::to_string(overlapping) +
                              " voxels belong to several segments; they carry the last one's label");
  return loaded;
}

}  // namespace

Loaded<Image> readDicomImage(const DicomSeries& series, const Progress& progress) {
  if (series.segmentation)
    throw InputError("DICOM series " + series.code +
                     " is a segmentation; give it as a label map, and a CT here");
  return readValues(series, Between::Linear, progress);
}

Loaded<LabelMap> readDicomLabels(const DicomSeries& series, const Progress& progress) {
  if (series.segmentation) return readSegments(series, progress);
  const Loaded<Image> values = readValues(series, Between::Nearest, progress);
  constexpr std::size_t kMostLabels = 256;
  std::set<float> distinct;
  float last = std::nanf("");
  for (const float value : values.value.voxels)
    if (value != last && distinct.size() <= kMostLabels) distinct.insert(last = value);
  const bool mask = distinct.size() <= 2;
  const bool whole = std::all_of(distinct.begin(), distinct.end(), [](float value) {
    return value >= 0 && value <= 65535 && value == std::floor(value);
  });
  if (!mask && (!whole || distinct.size() > kMostLabels))
    throw InputError("DICOM series " + series.code +
                     " holds intensities, no labels; give a mask series, a DICOM SEG or a label map");
  Loaded<LabelMap> loaded;
  loaded.warnings = values.warnings;
  loaded.value = emptyVolume<std::uint16_t>(series);
  const float background =
      distinct.size() == 1 && *distinct.begin() != 0 ? *distinct.begin() - 1 : *distinct.begin();
  for (std::size_t v = 0; v < loaded.value.voxels.size(); ++v) {
    const float value = values.value.voxels[v];
    loaded.value.voxels[v] = mask ? value > background : static_cast<std::uint16_t>(value);
  }
  return loaded;
}

DicomThumbnail readDicomMiddle(const DicomSeries& series) {
  DicomThumbnail picture;
  if (series.slices.empty()) return picture;
  const std::size_t middle = series.slices.size() / 2;
  forEachDicomSlice(
      series, {middle}, {},
      [&](std::size_t number, const DicomHeader& header, const std::vector<std::int32_t>& values) {
        const DicomFrame& frame = header.frames[series.slices[number].frame];
        picture.width = header.format.columns;
        picture.height = header.format.rows;
        for (const std::int32_t value : values)
          picture.values.push_back(static_cast<float>(frame.slope * value + frame.intercept));
      });
  return picture;
}

}  // namespace falciform
