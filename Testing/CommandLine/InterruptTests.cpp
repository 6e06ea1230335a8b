#include <gmock/gmock.h>

#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

TEST(Interrupt, EndsWith130AndLeavesNoFile) {
  const TemporaryFolder folder;
  RunOptions options;
  // The result folder appears before the computation starts; a liver of 0.8 mm edges takes far longer than
  // that.
  options.interruptWhen = [&] { return std::filesystem::exists(folder / "case"); };
  const Ran ran = falciform(
      {"synthesise", "--out", (folder / "case").string(), "--edge-length", "0.8", "--voxel", "0.7"}, options);
  EXPECT_EQ(ran.exitCode, 130) << ran.err;
  EXPECT_EQ(lineCount(ran.err), 1) << ran.err;
  EXPECT_TRUE(contentsOf(folder.path()).empty());
}

}  // namespace
}  // namespace falciform::test
