#include "Modules/DeformationAnalysis/CaseMaps.h"

#include <algorithm>
#include <cctype>

#include "Logic/Core/Errors.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/SurfaceFiles.h"

namespace falciform {
namespace {

namespace fs = std::filesystem;

constexpr char kPreopResult[] = "preop_distance.vtp", kScanResult[] = "scan_distance.vtp";
constexpr char kCohortCases[] = "cases";  // in what `falciform cohort` writes: a map a case, in its own LPS

/// "case2" before "case10".
bool before(const fs::path& a, const fs::path& b) {
  const std::string left = a.filename().string(), right = b.filename().string();
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < left.size() && j < right.size()) {
    if (!digit(left[i]) || !digit(right[j])) {
      if (left[i] != right[j]) return left[i] < right[j];
      ++i, ++j;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0') ++at;
      const std::size_t begin = at;
      while (at < text.size() && digit(text[at])) ++at;
      return text.substr(begin, at - begin);
    };
    const std::string one = number(left, i), other = number(right, j);
    if (one.size() != other.size()) return one.size() < other.size();
    if (one != other) return one < other;
  }
  return left.size() - i < right.size() - j;
}

bool isCase(const fs::path& place) {
  return fs::exists(place / "case.json") || place.filename() == "case.json";
}

std::string nameOf(const fs::path& place) {
  return (place.has_filename() ? place : place.parent_path()).filename().string();
}

template <class T>
T take(Loaded<T> loaded, std::vector<std::string>& warnings) {
  warnings.insert(warnings.end(), loaded.warnings.begin(), loaded.warnings.end());
  return std::move(loaded.value);
}

void measure(DistanceMap& map) {
  const auto all = [](const Surface& side) {
    const auto values = side.arrays.find(kSignedDistance);
    return distanceStatistics(values == side.arrays.end() ? VectorXd() : values->second);
  };
  map.preopAll = all(map.preop);
  map.scanAll = all(map.scan);
}

MappedCase ofCase(const fs::path& place, const DistanceSettings& settings, const Progress& progress,
                  std::vector<std::string>& warnings) {
  // Only what a map needs: volumes and vessels would be read for nothing.
  CaseDescription description = readCaseDescription(place);
  description.ct.clear();
  description.labelMap.clear();
  description.labels.clear();
  description.structures.clear();
  description.supports.clear();
  description.preopPatches.clear();
  Case document;
  const std::vector<std::string> read = openCase(document, description);
  warnings.insert(warnings.end(), read.begin(), read.end());
  MappedCase mapped;
  mapped.name =
      document.name().empty() || document.name() == "Untitled" ? nameOf(description.folder) : document.name();
  mapped.map = document.distance();
  if (document.registration()) mapped.lpsFromMap = document.registration()->scanFromPreop.inverse().matrix();
  if (mapped.map) return mapped;
  if (!document.preop() || !document.scan() || !document.registration())
    throw InputError("case '" + mapped.name +
                     "' has neither a distance map nor surface, scan and registration to compute one; "
                     "register it and save it");
  if (document.registrationStale())
    throw InputError("the registration of case '" + mapped.name +
                     "' is out of date; register it again and save it");
  mapped.map = std::make_shared<const DistanceMap>(mapDistances(
      *document.preop(), *document.scan(), document.registration()->scanFromPreop, settings, progress));
  return mapped;
}

MappedCase ofSurfaces(const fs::path& place, std::vector<std::string>& warnings) {
  MappedCase mapped;
  auto map = std::make_shared<DistanceMap>();
  if (fs::is_directory(place)) {
    mapped.name = nameOf(place);
    map->preop = take(readSurface(place / kPreopResult), warnings);
    if (fs::exists(place / kScanResult)) map->scan = take(readSurface(place / kScanResult), warnings);
  } else {
    mapped.name = place.stem().string();
    map->preop = take(readSurface(place), warnings);
  }
  if (map->preop.arrays.empty() && map->scan.arrays.empty())
    throw InputError("'" + place.filename().string() +
                     "' carries no values on its points; choose a distance map");
  measure(*map);
  mapped.map = std::move(map);
  return mapped;
}

}  // namespace

std::vector<fs::path> mapSourcesIn(const fs::path& folder) {
  if (isCase(folder) || fs::exists(folder / kPreopResult)) return {folder};
  if (fs::is_regular_file(folder)) return {folder};
  if (!fs::is_directory(folder))
    throw InputError("there is no folder '" + folder.string() + "'; choose another one");
  if (fs::is_directory(folder / kCohortCases)) return mapSourcesIn(folder / kCohortCases);
  std::vector<fs::path> cases, surfaces;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path& place = entry.path();
    if (entry.is_directory() && (isCase(place) || fs::exists(place / kPreopResult))) cases.push_back(place);
    if (entry.is_regular_file() && place.extension() == ".vtp") surfaces.push_back(place);
  }
  std::vector<fs::path>& found = cases.empty() ? surfaces : cases;
  if (found.empty())
    throw InputError("'" + folder.string() +
                     "' holds no case folders and no maps (.vtp); choose a case or a folder of cases");
  std::sort(found.begin(), found.end(), before);
  return found;
}

CaseMaps loadCaseMaps(const std::vector<fs::path>& sources, const DistanceSettings& settings,
                      const Progress& progress) {
  CaseMaps maps;
  std::string refusal;
  const auto count = static_cast<double>(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto at = static_cast<double>(i);
    progress.report(at / count, "Reading " + nameOf(sources[i]));
    // One unreadable case of many is no reason to show none: its words become a warning.
    try {
      maps.cases.push_back(
          isCase(sources[i])
              ? ofCase(sources[i], settings, progress.part(at / count, (at + 1) / count), maps.warnings)
              : ofSurfaces(sources[i], maps.warnings));
    } catch (const InputError& error) {
      refusal = error.what();
      maps.warnings.push_back(nameOf(sources[i]) + " is left out: " + refusal);
    }
  }
  if (maps.cases.empty())
    throw InputError(sources.size() == 1 ? refusal
                                         : "none of the cases can be shown; the first says: " + refusal);
  return maps;
}

}  // namespace falciform
