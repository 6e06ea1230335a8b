#include "Widgets/Jobs/FileGuess.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"

namespace falciform {
namespace {

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool namesAnyOf(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

std::vector<FileRole> guessSurface(const std::string& name, const std::string& extension) {
  const bool cloudOnly = extension == ".xyz" || extension == ".csv" || extension == ".pcd" ||
                         extension == ".rgbd" || extension == ".png";
  if (cloudOnly || namesAnyOf(name, {"scan", "intraop", "range", "lrs"})) return {FileRole::Scan};
  if (namesAnyOf(name, {"preop", "pre-op", "pre_op"})) return {FileRole::Preop};
  if (namesAnyOf(name, {"vessel", "vein", "artery", "tumour", "tumor", "portal", "gallbladder", "cyst"}))
    return {FileRole::Structure};
  return {FileRole::Preop, FileRole::Scan, FileRole::Structure};
}

/// Whether `word` stands in the name by itself: "ct" in "portal_ct.nii.gz", not in "structures.nii".
bool hasWord(const std::string& name, std::string_view word) {
  const auto letter = [&](std::size_t i) {
    return i < name.size() && std::isalpha(static_cast<unsigned char>(name[i]));
  };
  for (std::size_t at = name.find(word); at != std::string::npos; at = name.find(word, at + 1))
    if (!(at > 0 && letter(at - 1)) && !letter(at + word.size())) return true;
  return false;
}

std::vector<FileRole> guessVolume(const std::string& name) {
  return {hasWord(name, "ct") ? FileRole::Ct : FileRole::Labels};
}

std::vector<FileRole> guessDicom(const std::filesystem::path& path) {
  return isDicom(path) ? std::vector{FileRole::Ct, FileRole::Labels} : std::vector<FileRole>{};
}

}  // namespace

std::string_view fileRoleName(FileRole role) {
  switch (role) {
    case FileRole::Case:
      return "case";
    case FileRole::Labels:
      return "label map";
    case FileRole::Preop:
      return "pre-operative surface";
    case FileRole::Scan:
      return "intra-operative scan";
    case FileRole::Structure:
      return "structure inside the liver (vessel, tumour)";
    case FileRole::PreopLandmarks:
      return "landmarks on the pre-operative surface";
    case FileRole::ScanLandmarks:
      return "landmarks on the scan";
    case FileRole::Ct:
      return "CT volume";
    case FileRole::Targets:
      return "targets inside the liver";
    case FileRole::TruthTargets:
      return "true places of the targets, in the scan's frame";
  }
  return "";
}

std::vector<FileRole> guessFileRoles(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    return std::filesystem::exists(file / "case.json", ignored) ? std::vector{FileRole::Case}
                                                                : guessDicom(file);
  const std::string name = lowerCase(file.filename().string());
  const std::string extension = lowerCase(file.extension().string());
  if (isVolumeFile(file)) return guessVolume(name);
  if (name.ends_with(".mrk.json") || extension == ".fcsv") {
    if (namesAnyOf(name, {"target"}))
      return {namesAnyOf(name, {"truth", "true"}) ? FileRole::TruthTargets : FileRole::Targets};
    if (namesAnyOf(name, {"scan", "intraop"})) return {FileRole::ScanLandmarks};
    if (namesAnyOf(name, {"preop", "pre-op", "pre_op"})) return {FileRole::PreopLandmarks};
    return {FileRole::PreopLandmarks, FileRole::ScanLandmarks};
  }
  if (extension == ".json") return {FileRole::Case};
  if (isSurfaceFile(file)) return guessSurface(name, extension);
  return guessDicom(file);
}

}  // namespace falciform
