#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Files may grow to `bytes` only while this lives: a full disk for any user, without one.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &old_);
    handler_ = signal(SIGXFSZ, SIG_IGN);
    const rlimit tight{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &tight);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    signal(SIGXFSZ, handler_);
  }

 private:
  rlimit old_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST(OutputFile, WritesAndReadsAnyBytes) {
  const TemporaryFolder folder;
  const std::string bytes = std::string("a\0b\r\n\xff", 6) + std::string(200'000, 'x');
  writeTextFile(folder / "t.txt", Overwrite::Refuse, bytes);
  EXPECT_EQ(readTextFile(folder / "t.txt"), bytes);
  EXPECT_EQ(entriesIn(folder.path()), 1);
}

TEST(OutputFile, RefusesToReplaceAndNamesForce) {
  const TemporaryFolder folder;
  put(folder / "t.txt", "old");
  EXPECT_THAT(refusalOf([&] { writeTextFile(folder / "t.txt", Overwrite::Refuse, "new"); }),
              AllOf(HasSubstr("t.txt"), HasSubstr("--force")));
  EXPECT_EQ(readTextFile(folder / "t.txt"), "old");
  writeTextFile(folder / "t.txt", Overwrite::Replace, "new");
  EXPECT_EQ(readTextFile(folder / "t.txt"), "new");
}

TEST(OutputFile, DoesNotReplaceAFileThatAppearedWhileWriting) {
  const TemporaryFolder folder;
  const auto race = [&](const fs::path& temporary) {
    put(temporary, "mine");
    put(folder / "t.txt", "theirs");
  };
  EXPECT_THAT(refusalOf([&] { writeFile(folder / "t.txt", Overwrite::Refuse, race); }), HasSubstr("--force"));
  EXPECT_EQ(readTextFile(folder / "t.txt"), "theirs");
  EXPECT_EQ(entriesIn(folder.path()), 1);
}

TEST(OutputFile, AFailingWriterLeavesTheOldFileAndNoOther) {
  const TemporaryFolder folder;
  put(folder / "t.txt", "old");
  const auto failing = [](const fs::path& temporary) {
    put(temporary, "half of it");
    throw InputError("the writer gave up");
  };
  EXPECT_EQ(refusalOf([&] { writeFile(folder / "t.txt", Overwrite::Replace, failing); }),
            "the writer gave up");
  EXPECT_EQ(readTextFile(folder / "t.txt"), "old");
  EXPECT_EQ(entriesIn(folder.path()), 1);
  EXPECT_THROW(
      writeFile(folder / "u.txt", Overwrite::Refuse, [](const fs::path&) { throw std::logic_error("bug"); }),
      std::logic_error);
  EXPECT_EQ(entriesIn(folder.path()), 1);
}

TEST(OutputFile, AFullDiskIsToldAndLeavesTheOldFile) {
  const TemporaryFolder folder;
  for (const std::string name : {"s.txt", "s.ply", "s.vtp", "s.vtk", "s.stl", "s.obj"}) {
    put(folder / name, "old");
    std::string message;
    {
      const FullDisk full(1000);
      message = refusalOf([&] {
        if (name == "s.txt")
          writeTextFile(folder / name, Overwrite::Replace, std::string(5000, 'x'));
        else
          writeSurface(folder / name, fullSurface(), Overwrite::Replace);
      });
    }
    EXPECT_THAT(message, HasSubstr("make room")) << name;
    EXPECT_EQ(readTextFile(folder / name), "old") << name;
    fs::remove(folder / name);
    EXPECT_EQ(entriesIn(folder.path()), 0) << name;
  }
}

TEST(OutputFile, TheTemporaryNameKeepsTheExtensionsAndTheFolder) {
  const TemporaryFolder folder;
  for (const std::string extension : {".nii.gz", ".seg.nrrd", ".vtp", ""}) {
    fs::path seen;
    writeFile(folder / ("a" + extension), Overwrite::Refuse, [&](const fs::path& temporary) {
      seen = temporary;
      put(temporary, "x");
    });
    EXPECT_EQ(seen.parent_path(), folder.path());
    EXPECT_TRUE(seen.string().ends_with(extension)) << seen;
    EXPECT_NE(seen, folder / ("a" + extension));
  }
}

TEST(OutputFile, RefusesFoldersDevicesAndMissingFolders) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "d");
  const auto write = [](const fs::path& file) {
    return refusalOf([&] { writeTextFile(file, Overwrite::Replace, "x"); });
  };
  EXPECT_THAT(write(folder / "d"), HasSubstr("folder"));
  EXPECT_THAT(write(folder / "no" / "t.txt"), HasSubstr("there is no folder"));
  EXPECT_THAT(write("/dev/full"), HasSubstr("device"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_THAT(write("/sys/falciform.txt"), HasSubstr("cannot write"));  // not even root may
  EXPECT_THAT(write(folder.path() / ""), HasSubstr("names no file"));
  EXPECT_THAT(refusalOf([&] { (void)readTextFile("/dev/zero"); }), HasSubstr("device"));
  EXPECT_THAT(refusalOf([&] { (void)readTextFile(folder / "d"); }), HasSubstr("folder"));
  EXPECT_THAT(refusalOf([&] { (void)sha256OfFile(folder / "no"); }), HasSubstr("no such file"));
}

TEST(OutputFile, AnUnwritableFolderIsTold) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(refusalOf([&] { writeTextFile(folder / "t.txt", Overwrite::Refuse, "x"); }),
              HasSubstr("no permission"));
  EXPECT_THAT(refusalOf([&] { makeFolder(folder.path()); }), HasSubstr("no permission"));
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(OutputFile, ALinkStaysALinkAndPermissionsStay) {
  const TemporaryFolder folder;
  put(folder / "real.txt", "old");
  fs::permissions(folder / "real.txt", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(folder / "real.txt", folder / "link.txt");
  writeTextFile(folder / "link.txt", Overwrite::Replace, "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(readTextFile(folder / "real.txt"), "new");
  EXPECT_EQ(fs::status(folder / "real.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputFile, MakesFoldersWithTheirParentsAndSaysWhatIsInTheWay) {
  const TemporaryFolder folder;
  makeFolder(folder.path() / "a" / "b");
  makeFolder(folder.path() / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "b"));
  put(folder / "f", "x");
  EXPECT_THAT(refusalOf([&] { makeFolder(folder / "f"); }), HasSubstr("in the way"));
  EXPECT_NE(refusalOf([&] { makeFolder(folder.path() / "f" / "g"); }), "no error");
}

TEST(Sha256, GivesTheDigestsOfTheStandard) {
  const TemporaryFolder folder;
  put(folder / "empty", "");
  put(folder / "abc", "abc");
  put(folder / "million", std::string(1'000'000, 'a'));  // FIPS 180-2, appendix B.3
  EXPECT_EQ(sha256OfFile(folder / "empty"),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256OfFile(folder / "abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256OfFile(folder / "million"),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace falciform
