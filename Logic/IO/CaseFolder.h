#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Case.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// What `case.json` says: files (relative to the folder) and settings. Every entry but the name is optional.
struct CaseDescription {
  std::filesystem::path folder;
  std::string name;
  std::string labelMap;  ///< label map file; with `labels`, the values that are liver
  std::vector<int> labels;
  std::string preop;         ///< pre-op surface file (instead of, or made from, the label map)
  std::string preopPatches;  ///< a painted surface whose patches are transferred to the imported one
  std::string scan;
  std::string preopLandmarks, scanLandmarks;
  std::vector<std::pair<std::string, std::string>> structures;  ///< name, surface file: vessels, tumours
  std::string registration;  ///< scan_from_preop transform saved with the case
  std::string distance;      ///< saved distance map (.json; its surfaces lie beside it)
  std::string ct;            ///< the CT that the surface was made of
  std::string supports;      ///< painted supports of the pre-op surface (.json)
  std::string update;        ///< what a model update came to (.json; its surfaces lie beside it)
  std::string view;          ///< how the window showed the case (.json); nothing is computed from it
  nlohmann::json settings =
      nlohmann::json::object();  ///< {"import": {...}, "registration": {...}, "distance": {...}}
  std::string targets,
      truthTargets;  ///< landmark files for target error: pre-op and where they truly are in the scan's frame
};

/// Reads FOLDER/case.json (or the given .json file). Throws InputError naming the key for anything wrong.
[[nodiscard]] CaseDescription readCaseDescription(const std::filesystem::path& folderOrFile);
void writeCaseDescription(const CaseDescription& description, Overwrite overwrite);

/// Saves everything the case holds into `folder` with its case.json (whole-case save; registration.json holds
/// the result). A `view` that is not empty becomes view.json; else what stands there is kept.
void saveCase(const Case& document, const std::filesystem::path& folder, Overwrite overwrite,
              const nlohmann::json& view = {});
/// Clears `document` and fills it from a folder that saveCase or the user wrote; returns warnings of the
/// readers.
std::vector<std::string> openCase(Case& document, const std::filesystem::path& folderOrFile);
/// The same of what a description names, which may be less than its folder holds.
std::vector<std::string> openCase(Case& document, const CaseDescription& description);

}  // namespace falciform
