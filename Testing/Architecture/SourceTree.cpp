#include "Testing/Architecture/SourceTree.h"

#include <algorithm>
#include <fstream>
#include <regex>

namespace falciform::test {

namespace {

SourceFile read(const std::filesystem::path& file) {
  static const std::regex quoted("^\\s*#\\s*include\\s*\"([^\"]+)\""),
      system("^\\s*#\\s*include\\s*<([^>]+)>");
  SourceFile source;
  source.path = std::filesystem::relative(file, sourceRoot()).generic_string();
  std::ifstream stream(file);
  std::smatch found;
  for (std::string line; std::getline(stream, line);) {
    if (std::regex_search(line, found, quoted)) source.quotedIncludes.push_back(found[1]);
    if (std::regex_search(line, found, system)) source.systemIncludes.push_back(found[1]);
    source.lines.push_back(line);
  }
  return source;
}

}  // namespace

std::string SourceFile::folder(int count) const {
  std::size_t end = 0;
  for (int i = 0; i < count; ++i) end = path.find('/', end + (i > 0));
  return path.substr(0, end);
}

std::filesystem::path sourceRoot() { return FALCIFORM_SOURCE_DIR; }

const std::vector<SourceFile>& sourceFiles() {
  static const std::vector<SourceFile> files = [] {
    std::vector<SourceFile> all;
    for (const char* top : {"Logic", "Widgets", "Modules", "Testing"})
      for (const auto& entry : std::filesystem::recursive_directory_iterator(sourceRoot() / top))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
          all.push_back(read(entry.path()));
    std::sort(all.begin(), all.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return all;
  }();
  return files;
}

}  // namespace falciform::test
