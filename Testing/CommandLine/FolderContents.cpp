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
  EXPECT_EQ(lineCount(ran.err), 1) << ran.err;
  EXPECT_THAT(ran.err, testing::StartsWith("falciform: "));
  EXPECT_THAT(ran.err, testing::HasSubstr(mention));
  EXPECT_TRUE(contentsOf(folder) == before) << "files changed, appeared or went in " << folder;
}

}  // namespace falciform::test
