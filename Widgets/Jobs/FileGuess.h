#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace falciform {

/// What a file can be to a case.
enum class FileRole {
  Case,
  Labels,
  Preop,
  Scan,
  Structure,
  PreopLandmarks,
  ScanLandmarks,
  Ct,
  Targets,
  TruthTargets
};

/// In words, as on screen: "pre-operative surface".
[[nodiscard]] std::string_view fileRoleName(FileRole role);

/// What `file` may be, the likeliest first; one entry when there is no doubt, none when no reader takes it.
/// Goes by the extension, and between surface, scan and structure, or the two landmark lists, by the words in
/// its name; where those do not tell, all of them stand and the user is asked. DICOM is known by its content.
[[nodiscard]] std::vector<FileRole> guessFileRoles(const std::filesystem::path& file);

}  // namespace falciform
