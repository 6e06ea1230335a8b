#pragma once
#include <map>
#include <string>
#include <vector>

namespace falciform {

/// The string arrays of a VTP file's <FieldData>, by name, and the file with that block blanked out: VTK's
/// reader walks past the end of a string array whose count or last byte is damaged. Arrays that cannot be
/// decoded are left out. Inside Logic/IO only.
struct VtpFieldTexts {
  std::string fileWithout;
  std::map<std::string, std::vector<std::string>> texts;
};

[[nodiscard]] VtpFieldTexts takeFieldTexts(std::string file);

}  // namespace falciform
