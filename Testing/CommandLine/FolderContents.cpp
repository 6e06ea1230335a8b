#include "Testing/CommandLine/FolderContents.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace falciform::test {

std::map<std::string, std::string> contentsOf(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::ostringstream bytes;
    if (entry.is_regular_file()) bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    contents[entry.path().lexically_relative(folder).string()] = bytes.str();
  }
  return contents;
}

void expectRefusal(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                   const std::string& mention, const RunOptions& options) {
  const auto before = contentsOf(folder);
  const Ran ran = falciform(arguments, options);
  EXPECT_EQ(ran.exitCode, 2) << ran.err;
  // Readers may warn first; the refusal is the one line that is no warning.
  std::istringstream lines(ran.err);
  std::string refusal;
  int refusals = 0;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("warning: ")) {
      refusal = line;
      ++refusals;
    }
  EXPECT_EQ(refusals, 1) << ran.err;
  EXPECT_THAT(refusal, testing::StartsWith("falciform: "));
  EXPECT_THAT(refusal, testing::HasSubstr(mention));
  EXPECT_TRUE(contentsOf(folder) == before) << "files changed, appeared or went in " << folder;
}

}  // namespace falciform::test
