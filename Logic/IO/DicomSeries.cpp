#include "Logic/IO/DicomSeries.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/IO/DicomGroups.h"
#include "Logic/IO/DicomPixels.h"
#include "Logic/IO/DicomWords.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 200000;

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
  throw InputError("'" + path.string() + "': " + what);
}

template <class Iterator>
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (Iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored)) continue;
    files.push_back(entry->path());
    if (files.size() > kMostFiles)
      refuse(folder,
             "it holds more than " + std::to_string(kMostFiles) + " files; give the folder of one study");
  }
  if (error) refuse(folder, "the folder cannot be read; check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

struct Found {
  std::optional<DicomFileHeader> header;
  bool dicom = false;
  std::string reason;
};

Found lookAt(const fs::path& file) {
  Found found;
  if (!beginsAsDicom(file)) return found;
  found.dicom = true;
  try {
    const DicomFile parsed = readDicomFile(file);
    DicomFileHeader header{file, {}, dicomHeader(parsed)};
    checkPixelData(parsed, header.header.format, header.header.frames.size());
    header.folderWords = plainWords(parsed.data, fs::absolute(file).parent_path().filename().string());
    found.header = std::move(header);
  } catch (const InputError& error) {
    found.reason = error.what();
  }
  return found;
}

std::string choices(const DicomListing& listing) {
  std::string text;
  for (std::size_t s = 0; s < listing.series.size() && s < 20; ++s)
    text += (s ? "; " : "") + describeSeries(listing.series[s], s + 1);
  return text;
}

}  // namespace

DicomListing listDicom(const fs::path& path, const Progress& progress) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) refuse(path, "no such file or folder; check the path");
  const bool folder = fs::is_directory(path, ignored);
  if (!folder && !beginsAsDicom(path)) refuse(path, "this is no DICOM file; give one, or a folder of them");
  const fs::path beside = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const auto files =
      folder ? filesIn<fs::recursive_directory_iterator>(path) : filesIn<fs::directory_iterator>(beside);
  std::vector<Found> found(files.size());
  constexpr std::size_t kAtOnce = 64;
  for (std::size_t begin = 0; begin < files.size(); begin += kAtOnce) {
    progress.report(static_cast<double>(begin) / static_cast<double>(files.size()), "Reading DICOM headers");
    forEachChunk(std::min(kAtOnce, files.size() - begin), 4, [&](std::size_t from, std::size_t to) {
      for (std::size_t f = begin + from; f < begin + to; ++f) found[f] = lookAt(files[f]);
    });
  }
  DicomListing listing;
  std::vector<DicomFileHeader> headers;
  std::map<std::string, std::size_t> reasons;
  for (Found& one : found) {
    if (one.header)
      headers.push_back(std::move(*one.header));
    else if (one.dicom)
      ++reasons[one.reason];
    else
      ++listing.otherFiles;
  }
  for (const auto& [reason, count] : reasons)
    listing.unreadable.push_back(std::to_string(count) + (count == 1 ? " DICOM file" : " DICOM files") +
                                 " left out: " + reason);
  listing.series = groupDicom(std::move(headers));
  if (!folder) {
    std::erase_if(listing.series, [&](const DicomSeries& series) {
      return std::none_of(series.slices.begin(), series.slices.end(),
                          [&](const DicomSlice& slice) { return slice.file.filename() == path.filename(); });
    });
  }
  if (listing.series.empty())
    refuse(path, listing.unreadable.empty()
                     ? "no DICOM series in it; give the folder that the scanner's export made"
                     : "no series of slices in it: " + listing.unreadable.front());
  progress.report(1);
  return listing;
}

bool isDicom(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return beginsAsDicom(path);
  constexpr int kMostTried = 2000;  // a home folder is not searched to its end
  int tried = 0;
  for (fs::recursive_directory_iterator entry(path, fs::directory_options::skip_permission_denied, error),
       end;
       !error && entry != end && tried < kMostTried; entry.increment(error), ++tried) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && beginsAsDicom(entry->path())) return true;
  }
  return false;
}

std::string describeSeries(const DicomSeries& series, std::size_t number) {
  const Vector3d mm = series.spacingMm();
  char text[160];
  std::snprintf(text, sizeof text, ", %d x %d x %d voxels of %.3f x %.3f x %.3f mm, %zu %s [%s]",
                series.size.x(), series.size.y(), series.size.z(), mm.x(), mm.y(), mm.z(), series.files,
                series.files == 1 ? "file" : "files", series.code.c_str());
  const std::string what =
      series.modality + (series.description.empty() ? "" : " '" + series.description + "'");
  const std::string cannot = series.refusal.empty() ? "" : ": cannot be read: " + series.refusal;
  if (!cannot.empty())
    return std::to_string(number) + ": " + what + ", " + std::to_string(series.files) + " files [" +
           series.code + "]" + cannot;
  return std::to_string(number) + ": " + what + text;
}

const DicomSeries& chooseSeries(const DicomListing& listing, const std::string& choice) {
  const DicomSeries* chosen = nullptr;
  if (choice.empty()) {
    std::size_t readable = 0;
    for (const DicomSeries& series : listing.series)
      if (series.refusal.empty() || listing.series.size() == 1) {
        chosen = &series;
        ++readable;
      }
    if (readable > 1 || !chosen)
      throw InputError("the DICOM folder holds " + std::to_string(listing.series.size()) +
                       " series; choose one with --series NUMBER: " + choices(listing));
  } else {
    const auto number = toWhole(choice);
    for (std::size_t s = 0; s < listing.series.size(); ++s)
      if (listing.series[s].code == choice ||
          (choice.size() < 8 && number && *number == static_cast<std::int64_t>(s + 1)))
        chosen = &listing.series[s];
    if (!chosen)
      throw InputError("there is no DICOM series " + inQuotes(choice) +
                       "; choose one of: " + choices(listing));
  }
  if (!chosen->refusal.empty()) throw InputError("DICOM series " + chosen->code + ": " + chosen->refusal);
  return *chosen;
}

}  // namespace falciform
