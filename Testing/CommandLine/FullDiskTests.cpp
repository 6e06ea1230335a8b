#include <gmock/gmock.h>
#include <sys/mount.h>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

TEST(FullDisk, LeavesNothingBehindWhereFilesCannotGrow) {
  const TemporaryFolder folder;
  writeSmallCase(folder.path());
  writeLabelMap(folder / "ball.nii.gz", ballMap(), Overwrite::Refuse);
  RunOptions small;
  small.largestFile = 8192;
  expectRefusal({"import", (folder / "ball.nii.gz").string(), "--out", (folder / "liver.vtp").string()},
                folder.path(), "liver.vtp", small);
  expectRefusal({"register", "--preop", (folder / "preop.vtp").string(), "--scan",
                 (folder / "scan.vtp").string(), "--out", (folder / "out").string()},
                folder.path(), "the disk is full", small);
}

TEST(FullDisk, LeavesNothingBehindOnASmallFileSystem) {
  const TemporaryFolder folder;
  const std::filesystem::path disk = folder / "disk";
  std::filesystem::create_directory(disk);
  if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "needs the right to mount a tmpfs";
  writeLabelMap(folder / "ball.nii.gz", ballMap(), Overwrite::Refuse);
  expectRefusal({"import", (folder / "ball.nii.gz").string(), "--out", (disk / "liver.vtp").string()}, disk,
                "liver.vtp");
  umount(disk.c_str());
}

TEST(FullDisk, ResultsThatCannotBePrintedAreAnError) {
  const TemporaryFolder folder;
  writeSmallCase(folder.path());
  RunOptions full;
  full.standardOutput = "/dev/full";
  expectRefusal({"info", (folder / "preop.vtp").string()}, folder.path(), "standard output", full);
}

}  // namespace
}  // namespace falciform::test
