#include <gmock/gmock.h>

#include "Logic/Registration/RegistrationSettings.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Usage, VersionAndHelpSucceedOnStandardOutput) {
  for (const char* word : {"--version", "--help", "help"}) {
    const Ran ran = falciform({word});
    EXPECT_EQ(ran.exitCode, 0) << word;
    EXPECT_THAT(ran.out, HasSubstr("alciform "));
    EXPECT_EQ(ran.err, "") << word;
  }
}

TEST(Usage, OverviewNamesEveryCommand) {
  const Ran ran = falciform({"--help"});
  for (const char* name : {"segment", "import", "patches", "register", "distance", "normalise", "cohort",
                           "run", "demo", "synthesise", "trials", "mesh", "info"})
    EXPECT_THAT(ran.out, HasSubstr(std::string("\n  ") + name + " "));
}

TEST(Usage, MistakesAreOneLineWithExitCodeTwo) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& mention) {
    SCOPED_TRACE(mention);
    expectRefusal(arguments, folder.path(), mention);
  };
  refused({}, "no command");
  refused({"regster"}, "'regster'");
  refused({"register", "--bogus", "1"}, "--bogus");
  refused({"register", "--preop"}, "--preop");
  refused({"register", "--scan", "b.vtp", "--out", out}, "--preop is missing");
  refused({"import", "a.nii", "b.nii", "--out", out + ".vtp"}, "'b.nii'");
  refused({"import", "a.nii", "--out", out + ".vtp", "--edge-length", "-1"}, "[0, 50] mm");
  refused({"import", "a.nii", "--out", out + ".vtp", "--edge-length", "nan"}, "[0, 50] mm");
  refused({"import", "a.nii", "--out", out + ".vtp", "--edge-length", "2mm"}, "'2mm'");
  refused({"import", "a.nii", "--out", out + ".vtp", "--label", "1,,2"}, "--label");
  refused({"import", "a.nii", "--out", out + ".vtp", "--label", "70000"}, "65535");
  refused({"register", "--preop", "a.vtp", "--scan", "b.vtp", "--out", out, "--method", "magic"},
          listOfNames(enumNames(RegistrationMethod{})));
  refused({"register", "--preop", "a.vtp", "--preop", "b.vtp", "--scan", "b.vtp", "--out", out}, "twice");
  refused({"register", "--preop", "a.vtp", "--scan", "b.vtp", "--out", out, "--targets", "t.fcsv"},
          "--truth-targets");
  refused({"patches", "--from", "a.vtp", "--out", out + ".vtp"}, "--to is missing");
  refused({"import", "a.nii", "--out", out + ".xyz"}, ".vtp, .vtk, .stl, .ply or .obj");
  refused({"info", "nowhere.vtp"}, "'nowhere.vtp' does not exist");
}

TEST(Usage, OptionsTakeTheirValueWithASpaceOrAnEqualsSign) {
  const TemporaryFolder folder;
  const Ran spaced = falciform({"info", (folder / "x.vtp").string(), "--seed", "abc"});
  const Ran equals = falciform({"info", (folder / "x.vtp").string(), "--seed=abc"});
  EXPECT_THAT(spaced.err, HasSubstr("'abc'"));
  EXPECT_EQ(spaced.err, equals.err);
}

}  // namespace
}  // namespace falciform::test
