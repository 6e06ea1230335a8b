#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "Testing/Architecture/SourceTree.h"

namespace falciform::test {
namespace {

TEST(HouseRules, NoFileIsOver400LinesAndTheMedianIsAtMost100) {
  std::vector<std::size_t> lengths;
  for (const SourceFile& file : sourceFiles()) {
    EXPECT_LE(file.lines.size(), 400u) << file.path << ": split it by idea";
    lengths.push_back(file.lines.size());
  }
  ASSERT_FALSE(lengths.empty());
  std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2),
                   lengths.end());
  EXPECT_LE(lengths[lengths.size() / 2], 100u);
}

TEST(HouseRules, TopLevelHoldsOnlyTheAgreedFolders) {
  const std::set<std::string> agreed{"Logic", "Widgets", "Modules", "Resources", "Testing", "Docs"};
  for (const auto& entry : std::filesystem::directory_iterator(sourceRoot())) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() && name[0] != '.') {
      EXPECT_TRUE(agreed.contains(name)) << name;
    }
  }
}

TEST(HouseRules, EachSettingsStructIsDescribedOnce) {
  const std::regex declared("^struct (\\w+Settings)\\b"), described("describe\\((\\w+Settings)&");
  std::map<std::string, int> descriptions;
  std::set<std::string> structs;
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) == "Testing") continue;
    std::smatch found;
    for (const std::string& line : file.lines) {
      if (std::regex_search(line, found, declared) && file.folder(1) == "Logic") structs.insert(found[1]);
      if (std::regex_search(line, found, described)) ++descriptions[found[1]];
    }
  }
  ASSERT_GE(structs.size(), 5u);
  for (const std::string& name : structs) EXPECT_EQ(descriptions[name], 1) << name;
}

TEST(HouseRules, LibrariesDoNotPrint) {
  const std::regex printing("std::(cout|cerr|clog)\\b|\\b(printf|puts|fprintf)\\s*\\(");
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) != "Logic" && file.folder(1) != "Widgets") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      EXPECT_FALSE(std::regex_search(file.lines[i], printing)) << file.path << ":" << i + 1;
  }
}

TEST(HouseRules, NoCatchAllNames) {
  const std::regex vague("(Utils?|Helpers?|Manager|Misc|Common)\\.(h|cpp)$");
  for (const SourceFile& file : sourceFiles()) EXPECT_FALSE(std::regex_search(file.path, vague)) << file.path;
}

TEST(HouseRules, ErrorsAreCaughtOnlyWhereTheyAreShown) {
  // JobRunner and the command line's main show errors. Anyone else may catch one only to throw it on with the
  // file's name, or to keep it in a list of files that were left out, or as a warning of what was read
  // without.
  const std::regex caught("catch \\(const InputError&");
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) != "Logic" && file.folder(2) != "Widgets/Rendering") continue;
    for (std::size_t i = 0; i < file.lines.size(); ++i)
      if (std::regex_search(file.lines[i], caught)) {
        const std::string next = i + 1 < file.lines.size() ? file.lines[i + 1] : "";
        EXPECT_TRUE(next.find("throw InputError(") != std::string::npos ||
                    next.find(".reason = error.what()") != std::string::npos ||
                    next.find("warnings.push_back(") != std::string::npos)
            << file.path << ":" << i + 1;
      }
  }
}

}  // namespace
}  // namespace falciform::test
