#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "Logic/Atlas/KeptSolves.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/SlabLiver.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

AtlasJob job(double extentMm = 18) {
  AtlasDesign design = atlasPreset("thesis-packing");
  design.packing.places = 7;
  design.packing.extentMm = extentMm;
  const SlabLiver slab = slabLiver();
  return prepareAtlas(slab.mesh, slab.sites, design);
}

std::vector<Points> fieldsFor(const AtlasJob& of, int batch) {
  const AtlasSolves::Batch& b = of.solves.batches[static_cast<std::size_t>(batch)];
  std::vector<Points> fields;
  for (int k = b.first; k < b.last; ++k) fields.push_back(Points::Constant(of.mesh.nodes(), 3, k + 0.1));
  return fields;
}

TEST(KeptSolves, AreFoundAgainByAnotherProcessOfTheSameBuild) {
  const TemporaryFolder folder;
  const AtlasJob of = job();
  KeptSolves kept(folder / "a.part", basisOf(of, "1"), of);
  kept.open(false);
  EXPECT_FALSE(fs::exists(folder / "a.part"));  // nothing done, nothing left
  kept.keep(1, fieldsFor(of, 1));
  KeptSolves later(folder / "a.part", basisOf(job(), "1"), of);
  later.open(false);
  EXPECT_FALSE(later.has(0));
  ASSERT_TRUE(later.has(1));
  EXPECT_EQ(later.count(), 2);
  EXPECT_EQ(later.read(1), fieldsFor(of, 1));
  later.remove();
  EXPECT_FALSE(fs::exists(folder / "a.part"));
}

TEST(KeptSolves, OfAnotherDesignAreRefusedOrForgotten) {
  const TemporaryFolder folder;
  const AtlasJob of = job(), other = job(25);
  KeptSolves kept(folder / "a.part", basisOf(of, "1"), of);
  kept.keep(0, fieldsFor(of, 0));
  KeptSolves changed(folder / "a.part", basisOf(other, "1"), other);
  try {
    changed.open(false);
    FAIL() << "solves of another design were taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("interrupted build with another design"));
  }
  EXPECT_TRUE(kept.has(0));
  KeptSolves newer(folder / "a.part", basisOf(of, "2"), of);
  EXPECT_THROW(newer.open(false), InputError);
  changed.open(true);
  EXPECT_FALSE(kept.has(0));
}

TEST(KeptSolves, ThatAreDamagedAreSolvedAgain) {
  const TemporaryFolder folder;
  const AtlasJob of = job();
  KeptSolves kept(folder / "a.part", basisOf(of, "1"), of);
  kept.keep(0, fieldsFor(of, 0));
  fs::resize_file(folder / "a.part/solves-0.h5", fs::file_size(folder / "a.part/solves-0.h5") / 2);
  EXPECT_FALSE(kept.has(0));
  kept.keep(0, fieldsFor(of, 0));
  EXPECT_TRUE(kept.has(0));
}

TEST(KeptSolves, RemovingLeavesTheFilesOfOthers) {
  const TemporaryFolder folder;
  const AtlasJob of = job();
  KeptSolves kept(folder / "a.part", basisOf(of, "1"), of);
  kept.keep(0, fieldsFor(of, 0));
  std::ofstream(folder / "a.part/notes.txt") << "mine";
  kept.remove();
  EXPECT_TRUE(fs::exists(folder / "a.part/notes.txt"));
  EXPECT_FALSE(fs::exists(folder / "a.part/solves-0.h5"));
}

TEST(KeptSolves, TheFolderIsOneProcesssAtATime) {
  const TemporaryFolder folder;
  const AtlasJob of = job();
  KeptSolves kept(folder / "a.part", basisOf(of, "1"), of);
  kept.keep(0, fieldsFor(of, 0));
  std::atomic<int> inside = 0, most = 0;
  std::vector<std::thread> others;
  for (int k = 0; k < 4; ++k)
    others.emplace_back([&] {
      for (int round = 0; round < 20; ++round) {
        const KeptSolves::Turn turn(kept);
        most = std::max<int>(most, ++inside);
        std::this_thread::yield();
        --inside;
      }
    });
  for (std::thread& other : others) other.join();
  EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace falciform::test
