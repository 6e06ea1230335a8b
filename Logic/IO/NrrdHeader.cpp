#include "Logic/IO/NrrdHeader.h"

#include <algorithm>

#include "Logic/IO/VolumeLayout.h"

namespace falciform {

namespace {

/// Field names may be written with or without blanks ("data file", "datafile") and in any case.
std::string plainName(std::string_view name) {
  std::string plain = lowerCase(trimmed(name));
  std::erase(plain, ' ');
  if (plain == "centerings") return "centers";
  return plain;
}

}  // namespace

const std::string* NrrdHeader::field(const std::string& name) const {
  const auto found = fields.find(name);
  return found == fields.end() ? nullptr : &found->second;
}

const std::string& NrrdHeader::needed(const std::string& name) const {
  if (const std::string* value = field(name)) return *value;
  refuseVolume(file, "its header has no '" + name + "'; it is damaged: export it again");
}

NrrdHeader readNrrdHeader(const std::filesystem::path& file) {
  const HeaderLines text = readHeaderLines(file, [](std::string_view line) { return line.empty(); });
  if (text.lines.empty() || !text.lines[0].starts_with("NRRD"))
    refuseVolume(file, "this is no NRRD file; its first line must be 'NRRD0005' or alike");
  NrrdHeader header;
  header.file = file;
  header.end = text.end;
  for (std::size_t i = 1; i < text.lines.size(); ++i) {
    const std::string& line = text.lines[i];
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos)
      refuseVolume(file, "line " + std::to_string(i + 1) + " of its header is " + inQuotes(line) +
                             "; it must read 'name: value': correct the header");
    const std::string value(trimmed(std::string_view(line).substr(colon + 1)));
    if (value.starts_with('=') && colon + 1 < line.size() && line[colon + 1] == '=')
      header.keys[line.substr(0, colon)] = value.substr(1);
    else
      header.fields[plainName(std::string_view(line).substr(0, colon))] = value;
  }
  return header;
}

std::vector<std::optional<Vector3d>> nrrdVectors(const NrrdHeader& header, const std::string& name) {
  std::vector<std::optional<Vector3d>> vectors;
  std::string_view rest = trimmed(header.needed(name));
  while (!rest.empty()) {
    const std::size_t close = rest.find(')');
    if (rest.starts_with("none")) {
      vectors.emplace_back(std::nullopt);
      rest.remove_prefix(4);
    } else if (rest.starts_with('(') && close != std::string_view::npos) {
      const std::vector<double> v = numbersOf(header.file, name, rest.substr(1, close - 1), 3);
      vectors.emplace_back(Vector3d(v[0], v[1], v[2]));
      rest.remove_prefix(close + 1);
    } else {
      refuseVolume(header.file, "the header's '" + name + "' is " + inQuotes(header.needed(name)) +
                                    "; it must be vectors like (1,0,0), or none: correct the header");
    }
    rest = trimmed(rest);
  }
  return vectors;
}

std::vector<std::string> nrrdTexts(const std::string& value) {
  std::vector<std::string> texts;
  for (std::size_t open = value.find('"'); open != std::string::npos;) {
    const std::size_t close = value.find('"', open + 1);
    if (close == std::string::npos) break;
    texts.push_back(value.substr(open + 1, close - open - 1));
    open = value.find('"', close + 1);
  }
  return texts;
}

}  // namespace falciform
