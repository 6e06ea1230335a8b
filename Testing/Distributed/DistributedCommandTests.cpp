#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A coarse liver's mesh and a design of 8 places, 24 members, 2 batches of solves.
class DistributedCommand : public testing::Test {
 protected:
  DistributedCommand() {
    writeSurface(folder_ / "liver.vtp", makeSyntheticLiver({.edgeLengthMm = 6, .voxelMm = 6}).surface,
                 Overwrite::Refuse);
    std::ofstream(folder_ / "design.json")
        << R"({"preset": "thesis-packing", "packing": {"places": 8, "stepMm": 5, "maxPushMm": 15}})";
    const Ran meshed =
        falciform({"mesh", "--preop", at("liver.vtp"), "--out", at("mesh.vtu"), "--edge-length", "24"});
    EXPECT_EQ(meshed.exitCode, 0) << meshed.err;
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::string> of(const std::string& out) const {
    return {at("design.json"), "--preop", at("liver.vtp"), "--mesh", at("mesh.vtu"), "--out", at(out)};
  }
  [[nodiscard]] Ran build(const std::string& out) const {
    std::vector<std::string> words = of(out);
    words.insert(words.begin(), {"atlas", "build"});
    return falciform(words);
  }
  [[nodiscard]] Ran distributed(int ranks, const std::vector<std::string>& words) const {
    std::string call = "mpirun -n " + std::to_string(ranks) +
                       " --allow-run-as-root --oversubscribe '" DISTRIBUTED_EXECUTABLE "'";
    for (const std::string& word : words) call += " '" + word + "'";
    const int status = std::system((call + " > '" + at("told") + "' 2> '" + at("failed") + "'").c_str());
    return {WEXITSTATUS(status), readTextFile(folder_ / "told"), readTextFile(folder_ / "failed")};
  }

  TemporaryFolder folder_;
};

TEST_F(DistributedCommand, AtlasBuildGoesOnFromItsSolvesToTheSameAtlas) {
  ASSERT_EQ(build("one.h5").exitCode, 0);
  const Atlas wanted = readAtlas(folder_ / "one.h5").atlas;
  for (const int ranks : {1, 2}) {
    const std::string name = "by" + std::to_string(ranks) + ".h5";
    const Ran solved = distributed(ranks, of(name));
    ASSERT_EQ(solved.exitCode, 0) << solved.err;
    EXPECT_THAT(solved.out, HasSubstr("8 of 8 solves are kept in"));
    const Ran built = build(name);
    ASSERT_EQ(built.exitCode, 0) << built.err;
    EXPECT_THAT(built.out, HasSubstr("continued: 8 of 8 solves were done before"));
    const Atlas found = readAtlas(folder_ / name).atlas;
    ASSERT_EQ(found.figures.size(), wanted.figures.size());
    // The direct path of several setups ends in single precision: 1e-6 of the largest displacement.
    for (std::size_t m = 0; m < found.figures.size(); ++m) {
      EXPECT_NEAR(found.figures[m].maxMm, wanted.figures[m].maxMm, 1e-5 * wanted.figures[m].maxMm);
      EXPECT_NEAR(found.figures[m].rmsMm, wanted.figures[m].rmsMm, 1e-5 * wanted.figures[m].rmsMm);
    }
    ASSERT_EQ(found.rank(), wanted.rank());
    for (Index k = 0; k < wanted.singularValuesMm.size(); ++k)
      EXPECT_NEAR(found.singularValuesMm[k], wanted.singularValuesMm[k], 1e-5 * wanted.singularValuesMm[0]);
  }
}

TEST_F(DistributedCommand, GoesOnWhereItStood) {
  std::vector<std::string> second = of("a.h5");
  second.insert(second.end(), {"--shard", "1/2"});
  const Ran shard = distributed(2, second);
  ASSERT_EQ(shard.exitCode, 0) << shard.err;
  EXPECT_THAT(shard.out, HasSubstr("3 of 8 solves are kept in"));
  const Ran again = distributed(2, of("a.h5"));
  ASSERT_EQ(again.exitCode, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("solve 1 of 8"));
  EXPECT_THAT(again.out, testing::Not(HasSubstr("solve 6 of 8")));
}

TEST_F(DistributedCommand, MistakesAreToldOnceByWhicheverRanks) {
  const auto refused = [&](std::vector<std::string> words, const std::string& mention) {
    const Ran ran = distributed(2, words);
    EXPECT_EQ(ran.exitCode, 2) << mention;
    EXPECT_THAT(ran.err, HasSubstr(mention));
    const std::string::size_type once = ran.err.find("falciform-distributed: ");
    ASSERT_NE(once, std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find("falciform-distributed: ", once + 1), std::string::npos) << ran.err;
    EXPECT_FALSE(fs::exists(folder_ / "a.h5.part"));
  };
  refused({at("design.json"), "--preop", at("liver.vtp"), "--out", at("a.h5")}, "--mesh is not given");
  refused({at("design.json"), "--mesh", at("none.vtu"), "--out", at("a.h5")}, "none.vtu");
  std::vector<std::string> hasty = of("a.h5");
  hasty.insert(hasty.end(), {"--max-iterations", "2"});
  refused(hasty, "within 2 iterations");
  std::vector<std::string> shard = of("a.h5");
  shard.insert(shard.end(), {"--shard", "2/2"});
  refused(shard, "--shard is 2/2");
}

}  // namespace
}  // namespace falciform::test
