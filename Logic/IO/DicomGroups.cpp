#include "Logic/IO/DicomGroups.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DicomPixels.h"
#include "Logic/IO/DicomStack.h"
#include "Logic/IO/DicomWords.h"

namespace falciform {

namespace {

using Group = std::vector<const DicomFileHeader*>;

std::string rounded(double value, double unit) { return std::to_string(std::llround(value / unit)) + ' '; }

/// What the slices of one volume share.
std::string keyOf(const DicomFileHeader& file) {
  const DicomHeader& h = file.header;
  std::string key =
      h.seriesDigest + ' ' + std::to_string(h.format.rows) + ' ' + std::to_string(h.format.columns) + ' ';
  for (const double cosine : h.axes.reshaped()) key += rounded(cosine, 1e-3);
  for (const double spacing : h.spacingMm) key += rounded(spacing, 1e-3);
  // Files of many frames each are a volume of their own.
  if (h.frames.size() > 1 || h.segmentation) key += h.instanceDigest + file.file.string();
  return key;
}

double along(const DicomFileHeader& file) {
  return file.header.frames.front().position.dot(file.header.axes.col(0).cross(file.header.axes.col(1)));
}

std::size_t doubles(const Group& group) {
  std::vector<double> places;
  for (const DicomFileHeader* file : group) places.push_back(along(*file));
  std::sort(places.begin(), places.end());
  std::size_t equal = 0;
  for (std::size_t i = 1; i < places.size(); ++i) equal += places[i] - places[i - 1] <= kSamePlaceMm;
  return equal;
}

/// Cuts a group whose slices lie on one another by the first property that parts them.
std::vector<Group> parted(const Group& group) {
  if (group.front()->header.frames.size() > 1 || doubles(group) == 0) return {group};
  const std::function<std::string(const DicomFileHeader&)> properties[] = {
      [](const auto& f) { return f.file.parent_path().string(); },
      [](const auto& f) { return std::to_string(f.header.acquisition); },
      [](const auto& f) { return std::to_string(f.header.temporalPosition); }};
  for (const auto& property : properties) {
    std::map<std::string, Group> parts;
    for (const DicomFileHeader* file : group) parts[property(*file)].push_back(file);
    if (parts.size() < 2) continue;
    if (std::all_of(parts.begin(), parts.end(), [](const auto& part) { return doubles(part.second) == 0; })) {
      std::vector<Group> all;
      for (auto& [value, part] : parts) all.push_back(std::move(part));
      return all;
    }
  }
  return {group};
}

bool samePixels(const DicomFileHeader& a, const DicomFileHeader& b) {
  const auto valuesOf = [](const DicomFileHeader& file) {
    std::vector<std::int32_t> values;
    decodeFrame(readDicomFile(file.file), file.header.format, 0, 1, values);
    return values;
  };
  return valuesOf(a) == valuesOf(b);
}

/// Drops copies of a slice; says so, or why the series cannot be read.
void dropCopies(Group& group, DicomSeries& series) {
  std::stable_sort(group.begin(), group.end(),
                   [](const auto* a, const auto* b) { return along(*a) < along(*b); });
  Group kept;
  std::size_t copies = 0;
  for (const DicomFileHeader* file : group) {
    if (kept.empty() || along(*file) - along(*kept.back()) > kSamePlaceMm) {
      kept.push_back(file);
    } else if (file->header.instanceDigest == kept.back()->header.instanceDigest ||
               samePixels(*file, *kept.back())) {
      ++copies;
    } else {
      series.refusal =
          "different slices lie at the same place (several phases or reconstructions in one series); "
          "export each as its own series";
      return;
    }
  }
  if (copies > 0) series.warnings.push_back(std::to_string(copies) + " copies of slices were left out");
  group = std::move(kept);
}

void takeStack(const DicomStack& stack, DicomSeries& series, const DicomHeader& header) {
  series.warnings.insert(series.warnings.end(), stack.warnings.begin(), stack.warnings.end());
  if (series.refusal.empty()) series.refusal = stack.refusal;
  series.size = {header.format.columns, header.format.rows, std::max(1, stack.count)};
  series.worldFromIndex = stack.worldFromIndex;
  series.resampled = stack.resampled;
  if (!series.refusal.empty()) return;
  std::vector<DicomSlice> sorted;
  for (std::size_t s = 0; s < stack.order.size(); ++s) {
    sorted.push_back(series.slices[stack.order[s]]);
    sorted.back().index = stack.index[s];
  }
  series.slices = std::move(sorted);
}

/// Does not depend on names and places of files.
std::string codeOf(const Group& group) {
  std::string least = group.front()->header.instanceDigest;
  for (const DicomFileHeader* file : group) least = std::min(least, file->header.instanceDigest);
  return digestOf(group.front()->header.seriesDigest + least).substr(0, 8);
}

DicomSeries seriesOf(Group group) {
  DicomSeries series;
  const DicomHeader& first = group.front()->header;
  series.code = codeOf(group);
  series.modality = first.modality;
  series.description = first.description.empty() ? group.front()->folderWords : first.description;
  series.segmentation = first.segmentation;
  series.segments = first.segments;
  series.files = group.size();
  if (first.frames.size() == 1 && !first.segmentation) dropCopies(group, series);
  std::vector<Vector3d> positions;
  for (const DicomFileHeader* file : group)
    for (std::size_t f = 0; f < file->header.frames.size(); ++f) {
      const DicomFrame& frame = file->header.frames[f];
      series.slices.push_back({file->file, f, file->header.frames.size(), 0, frame.segment});
      positions.push_back(frame.position);
    }
  if (first.segmentation)
    takeStack(stackSegments(positions, first.axes, first.spacingMm, first.betweenSlicesMm), series, first);
  else
    takeStack(stackSlices(positions, first.axes, first.spacingMm), series, first);
  return series;
}

}  // namespace

std::vector<DicomSeries> groupDicom(std::vector<DicomFileHeader> files) {
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  std::vector<std::string> keys;
  std::map<std::string, Group> groups;
  for (const DicomFileHeader& file : files) {
    Group& group = groups[keyOf(file)];
    if (group.empty()) keys.push_back(keyOf(file));
    group.push_back(&file);
  }
  std::vector<DicomSeries> all;
  for (const std::string& key : keys)
    for (const Group& part : parted(groups[key])) all.push_back(seriesOf(part));
  return all;
}

}  // namespace falciform
