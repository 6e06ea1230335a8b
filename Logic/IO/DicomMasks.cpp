#include <algorithm>
#include <numeric>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DicomSeries.h"

namespace falciform {

namespace {

/// By one slice: masks have two values at most.
bool seemsMask(const DicomSeries& series) {
  if (series.segmentation || !series.refusal.empty()) return false;
  const std::vector<float> values = readDicomMiddle(series).values;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return std::all_of(values.begin(), values.end(),
                     [&](float value) { return value == *low || value == *high; });
}

std::map<int, std::string> namesOf(const DicomSeries& series, const LabelMap& map) {
  if (series.segmentation) return series.segments;
  const bool mask = std::all_of(map.voxels.begin(), map.voxels.end(), [](auto label) { return label <= 1; });
  if (!mask || series.description.empty()) return {};
  return {{1, series.description}};
}

}  // namespace

Loaded<NamedLabels> readDicomMasks(const std::vector<DicomSeries>& series, const Progress& progress) {
  if (series.empty()) throw InputError("no DICOM masks are given; choose at least one series");
  struct Mask {
    const DicomSeries* series;
    std::vector<bool> inside;
    std::size_t voxels = 0;
  };
  Loaded<NamedLabels> loaded;
  std::vector<Mask> masks;
  for (std::size_t s = 0; s < series.size(); ++s) {
    const auto from = static_cast<double>(s), all = static_cast<double>(series.size());
    Loaded<LabelMap> one = readDicomLabels(series[s], progress.part(from / all, (from + 1) / all));
    LabelMap& map = loaded.value.map;
    if (s == 0) map = LabelMap{one.value.size, one.value.worldFromIndex, {}};
    if (one.value.size != map.size ||
        (one.value.worldFromIndex - map.worldFromIndex).cwiseAbs().maxCoeff() > 1e-3)
      throw InputError("DICOM series " + series[s].code + " and " + series[0].code +
                       " do not share one grid; open them one by one with --series");
    Mask& mask = masks.emplace_back(Mask{&series[s], {}, 0});
    mask.inside.resize(one.value.voxels.size());
    for (std::size_t v = 0; v < one.value.voxels.size(); ++v) {
      if (one.value.voxels[v] > 1)
        throw InputError("DICOM series " + series[s].code +
                         " holds several labels; open it alone with --series");
      mask.inside[v] = one.value.voxels[v] != 0;
      mask.voxels += mask.inside[v];
    }
    for (const std::string& warning : one.warnings)
      loaded.warnings.push_back(series[s].code + ": " + warning);
  }
  std::stable_sort(masks.begin(), masks.end(),
                   [](const Mask& a, const Mask& b) { return a.voxels > b.voxels; });
  LabelMap& map = loaded.value.map;
  map.voxels.assign(masks.front().inside.size(), 0);
  for (std::size_t m = 0; m < masks.size(); ++m) {
    const auto label = static_cast<std::uint16_t>(m + 1);
    const std::string& words = masks[m].series->description;
    loaded.value.names[label] = words.empty() ? masks[m].series->code : words;
    for (std::size_t v = 0; v < map.voxels.size(); ++v)
      if (masks[m].inside[v]) map.voxels[v] = label;
  }
  return loaded;
}

Loaded<NamedLabels> readChosenLabels(const DicomListing& listing, const std::string& choice,
                                     const Progress& progress) {
  if (choice.empty() && listing.series.size() > 1 &&
      std::all_of(listing.series.begin(), listing.series.end(), seemsMask))
    return readDicomMasks(listing.series, progress);
  const DicomSeries& series = chooseSeries(listing, choice);
  Loaded<LabelMap> labels = readDicomLabels(series, progress);
  Loaded<NamedLabels> named;
  named.value.names = namesOf(series, labels.value);
  named.value.map = std::move(labels.value);
  named.warnings = std::move(labels.warnings);
  return named;
}

}  // namespace falciform
