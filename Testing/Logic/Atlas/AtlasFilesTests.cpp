#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/Atlas/Hdf5Store.h"
#include "Logic/Atlas/SealedFile.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/SlabLiver.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Atlas& smallAtlas() {
  static const Atlas atlas = [] {
    const SlabLiver slab = slabLiver(true);
    AtlasDesign design;
    design.kind = AtlasKind::Sampled;
    design.sampled = {.members = 12, .setups = 4, .minExtentMm = 12, .maxExtentMm = 25, .maxPushMm = 20};
    return buildAtlas(slab.mesh, slab.sites, design);
  }();
  return atlas;
}

const nlohmann::json kProvenance{
    {"program", "Falciform"}, {"version", "0"}, {"seed", 3}, {"command", "a \xff"}};

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void putBytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string refusalOf(const fs::path& file) {
  try {
    (void)readAtlas(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AtlasFiles, ReadBackWhatWasWrittenBitByBit) {
  const TemporaryFolder folder;
  const Atlas& atlas = smallAtlas();
  writeAtlas(folder / "a.h5", atlas, kProvenance);
  const StoredAtlas stored = readAtlas(folder / "a.h5");
  const Atlas& read = stored.atlas;
  EXPECT_EQ(stored.provenance.at("seed"), 3);
  EXPECT_EQ(toJson(read.design), toJson(atlas.design));
  EXPECT_EQ(read.mesh.points, atlas.mesh.points);
  EXPECT_EQ(read.mesh.elements, atlas.mesh.elements);
  EXPECT_EQ(read.mesh.regions, atlas.mesh.regions);
  EXPECT_EQ(read.mesh.frame, atlas.mesh.frame);
  EXPECT_EQ(read.nodeVolumesMm3, atlas.nodeVolumesMm3);
  ASSERT_EQ(read.rank(), atlas.rank());
  for (std::size_t k = 0; k < atlas.modes.size(); ++k) EXPECT_EQ(read.modes[k], atlas.modes[k]);
  EXPECT_EQ(read.coefficients, atlas.coefficients);
  EXPECT_EQ(read.stiffness, atlas.stiffness);
  EXPECT_EQ(read.singularValuesMm, atlas.singularValuesMm);
  EXPECT_EQ(read.energy, atlas.energy);
  EXPECT_EQ(read.solves, atlas.solves);
  ASSERT_EQ(read.members.size(), atlas.members.size());
  for (std::size_t m = 0; m < atlas.members.size(); ++m) {
    EXPECT_EQ(read.members[m].setup, atlas.members[m].setup);
    EXPECT_EQ(read.members[m].load(), atlas.members[m].load());
    EXPECT_EQ(read.members[m].gravityMPerS2, atlas.members[m].gravityMPerS2);
    EXPECT_EQ(read.figures[m].minDetJ, atlas.figures[m].minDetJ);
    EXPECT_EQ(read.figures[m].energyNMm, atlas.figures[m].energyNMm);
    EXPECT_EQ(read.figures[m].errorMm, atlas.figures[m].errorMm);
  }
  ASSERT_EQ(read.setups.size(), atlas.setups.size());
  for (std::size_t s = 0; s < atlas.setups.size(); ++s) {
    EXPECT_EQ(read.setups[s].name, atlas.setups[s].name);
    EXPECT_EQ(read.setups[s].pushed, atlas.setups[s].pushed);
    EXPECT_EQ(read.setups[s].centreMm, atlas.setups[s].centreMm);
    EXPECT_EQ(read.setups[s].extentMm, atlas.setups[s].extentMm);
    ASSERT_EQ(read.setups[s].supports.size(), atlas.setups[s].supports.size());
    for (std::size_t k = 0; k < atlas.setups[s].supports.size(); ++k) {
      EXPECT_EQ(read.setups[s].supports[k].kind, atlas.setups[s].supports[k].kind);
      EXPECT_EQ(read.setups[s].supports[k].faces, atlas.setups[s].supports[k].faces);
    }
  }
}

TEST(AtlasFiles, TheSameAtlasIsTheSameBytes) {
  const TemporaryFolder folder;
  writeAtlas(folder / "a.h5", smallAtlas(), kProvenance);
  writeAtlas(folder / "b.h5", smallAtlas(), kProvenance);
  EXPECT_EQ(bytesOf(folder / "a.h5"), bytesOf(folder / "b.h5"));
}

TEST(AtlasFiles, AreReadFromPythonInFiveLines) {
  if (std::system("/usr/bin/python3 -c 'import h5py, numpy' 2> /dev/null") != 0)
    GTEST_SKIP() << "needs python3-h5py and python3-numpy";
  const TemporaryFolder folder;
  const Atlas& atlas = smallAtlas();
  writeAtlas(folder / "a.h5", atlas, kProvenance);
  // The five lines of Docs/Atlas.md, then what they give.
  std::ofstream(folder / "read.py") << "import h5py, numpy as np\n"
                                       "f = h5py.File('a.h5')\n"
                                       "modes = f['modes/displacement_mm'][:]\n"
                                       "c = f['members/coefficients_mm'][:]\n"
                                       "u = np.tensordot(c[7], modes, 1)\n"
                                       "assert f.attrs['falciform_atlas_version'] == 1\n"
                                       "assert f['members/push_mm'].shape == (12,)\n"
                                       "assert b'\"kind\": \"sampled\"' in f['design_json'][()]\n"
                                       "np.savetxt('u.txt', u, '%.17g')\n";
  ASSERT_EQ(std::system(("cd '" + folder.path().string() + "' && /usr/bin/python3 read.py").c_str()), 0);
  const Points member = memberDisplacements(atlas, 7);
  std::ifstream text(folder / "u.txt");
  for (Index n = 0; n < member.rows(); ++n)
    for (Index axis = 0; axis < 3; ++axis) {
      double value = 0;
      ASSERT_TRUE(text >> value);
      EXPECT_NEAR(value, member(n, axis), 1e-12);  // mm; the order of the sums may differ
    }
}

TEST(AtlasFiles, ForeignFilesAreRefusedInOneLine) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusalOf(folder / "none.h5"), HasSubstr("does not exist"));
  EXPECT_THAT(refusalOf(folder.path()), HasSubstr("is a folder"));
  for (const std::string& bytes : {std::string(), std::string("solid liver"), std::string(4000, '\0')}) {
    putBytes(folder / "foreign.h5", bytes);
    EXPECT_THAT(refusalOf(folder / "foreign.h5"), HasSubstr("is no falciform atlas"));
  }
  {
    Hdf5Writer other(folder / "other.h5");
    other.attribute("falciform_atlas_version", 1);
    other.close();
  }
  EXPECT_THAT(refusalOf(folder / "other.h5"), HasSubstr("is no falciform atlas"));
  sealFile(folder / "other.h5", "falciform atlas", 1);
  EXPECT_THAT(refusalOf(folder / "other.h5"), HasSubstr("'provenance_json' is missing"));
  sealFile(folder / "other.h5", "falciform atlas", 2);
  EXPECT_THAT(refusalOf(folder / "other.h5"), HasSubstr("newer than this program reads"));
}

TEST(AtlasFiles, TextsThatAreNoObjectsAreRefusedInOneLine) {
  const TemporaryFolder folder;
  for (const std::string& text : {std::string("null"), std::string("[1]"), std::string("{")}) {
    {
      Hdf5Writer other(folder / "other.h5");
      other.text("provenance_json", text);
      other.close();
    }
    sealFile(folder / "other.h5", "falciform atlas", 1);
    EXPECT_THAT(refusalOf(folder / "other.h5"), HasSubstr("provenance_json is no JSON object")) << text;
  }
}

TEST(AtlasFiles, DamagedFilesAreRefusedInOneLineWhereverTheDamageIs) {
  const TemporaryFolder folder;
  writeAtlas(folder / "a.h5", smallAtlas(), kProvenance);
  const std::string whole = bytesOf(folder / "a.h5");
  Draws draws(5);
  for (int k = 0; k < 60; ++k) {
    putBytes(folder / "cut.h5", whole.substr(0, static_cast<std::size_t>(draws.uniform() * whole.size())));
    EXPECT_NE(refusalOf(folder / "cut.h5"), "") << k;
    std::string flipped = whole;
    // Past the head's padding every bit counts.
    flipped[512 + static_cast<std::size_t>(draws.uniform() * (whole.size() - 512))] ^=
        static_cast<char>(1 << static_cast<int>(draws.uniform(0, 8)));
    putBytes(folder / "flipped.h5", flipped);
    EXPECT_THAT(refusalOf(folder / "flipped.h5"), HasSubstr("has changed since it was written")) << k;
  }
  putBytes(folder / "longer.h5", whole + "x");
  EXPECT_THAT(refusalOf(folder / "longer.h5"), HasSubstr("copy it again"));
}

TEST(AtlasFiles, ContentsThatDoNotFitTogetherAreRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::function<void(Atlas&)>& spoil) {
    Atlas atlas = smallAtlas();
    spoil(atlas);
    writeAtlas(folder / "a.h5", atlas, kProvenance);
    return refusalOf(folder / "a.h5");
  };
  EXPECT_THAT(refused([](Atlas& a) { a.members[3].setup = 77; }), HasSubstr("member 3 has setup 77"));
  EXPECT_THAT(refused([](Atlas& a) { a.figures.pop_back(); }), HasSubstr("members/rms_mm"));
  EXPECT_THAT(refused([](Atlas& a) { a.coefficients(0, 0) = std::nan(""); }), HasSubstr("not finite"));
  EXPECT_THAT(refused([](Atlas& a) { a.mesh.elements(0, 0) = 1 << 30; }), HasSubstr("names node"));
  EXPECT_THAT(refused([](Atlas& a) { a.coefficients.conservativeResize(12, 1); }),
              HasSubstr("members/coefficients_mm"));
  EXPECT_EQ(refused([](Atlas&) {}), "");
}

}  // namespace
}  // namespace falciform::test
