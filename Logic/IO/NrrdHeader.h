#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

/// The text header of a NRRD file, attached (.nrrd) or detached (.nhdr).
struct NrrdHeader {
  std::filesystem::path file;
  std::map<std::string, std::string>
      fields;  ///< "name: value", lower-case names without blanks: "spacedirections"
  std::map<std::string, std::string> keys;  ///< "key:=value", as they stand
  std::uint64_t end = 0;                    ///< bytes of the header with the blank line after it

  [[nodiscard]] const std::string* field(const std::string& name) const;
  /// Throws InputError if it is not there.
  [[nodiscard]] const std::string& needed(const std::string& name) const;
};

/// Throws InputError if the file is no NRRD or a line of its header cannot be understood.
[[nodiscard]] NrrdHeader readNrrdHeader(const std::filesystem::path& file);

/// "(1,0,0)" as a vector, "none" as nothing; one per axis. Throws InputError for anything else.
[[nodiscard]] std::vector<std::optional<Vector3d>> nrrdVectors(const NrrdHeader& header,
                                                               const std::string& name);

/// "\"mm\" \"mm\" \"mm\"": the texts between quotes.
[[nodiscard]] std::vector<std::string> nrrdTexts(const std::string& value);

}  // namespace falciform
