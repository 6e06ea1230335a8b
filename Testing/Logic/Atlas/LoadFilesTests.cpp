#include <gmock/gmock.h>

#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/LoadFiles.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/SlabLiver.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

const nlohmann::json kProvenance{{"seed", 3}};

const LoadAtlas& smallLoads() {
  static const LoadAtlas made = [] {
    AtlasDesign design = atlasPreset("surface-loads");
    design.surfaceLoads = {.centres = 5, .radiusMm = 25};
    return buildLoadAtlas(slabLiver(true).mesh, design);
  }();
  return made;
}

template <class Read>
std::string refusalOf(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LoadFiles, ReadBackWhatWasWrittenBitByBit) {
  const TemporaryFolder folder;
  const LoadAtlas& loads = smallLoads();
  writeLoadAtlas(folder / "a.h5", loads, kProvenance);
  EXPECT_EQ(atlasKindOf(folder / "a.h5"), AtlasKind::SurfaceLoads);
  const StoredLoads read = readLoadAtlas(folder / "a.h5");
  EXPECT_EQ(read.provenance.at("seed"), 3);
  EXPECT_EQ(toJson(read.atlas.design), toJson(loads.design));
  EXPECT_EQ(read.atlas.loads.mesh.points, loads.loads.mesh.points);
  EXPECT_EQ(read.atlas.loads.mesh.elements, loads.loads.mesh.elements);
  EXPECT_EQ(read.atlas.loads.centres, loads.loads.centres);
  EXPECT_EQ(read.atlas.loads.responses, loads.loads.responses);
  EXPECT_EQ(read.atlas.loads.rmsMm, loads.loads.rmsMm);
}

TEST(LoadFiles, TheDesignDecidesTheLoads) {
  EXPECT_EQ(smallLoads().loads.loads(), 15);
  const LoadResponses same = solveSurfaceLoads(slabLiver(true).mesh, materialsOf(smallLoads().design),
                                               {.centres = 5, .radiusMm = 25});
  EXPECT_EQ(smallLoads().loads.responses, same.responses);
}

TEST(LoadFiles, OneKindOfAtlasIsNotTakenForTheOther) {
  const TemporaryFolder folder;
  writeLoadAtlas(folder / "loads.h5", smallLoads(), kProvenance);
  EXPECT_THAT(refusalOf([&] { (void)readAtlas(folder / "loads.h5"); }), HasSubstr("surface loads, not of"));
  AtlasDesign design;
  design.packing = {.places = 2, .extentMm = 15, .stepMm = 5, .maxPushMm = 10};
  const SlabLiver slab = slabLiver(true);
  writeAtlas(folder / "packing.h5", buildAtlas(slab.mesh, slab.sites, design), kProvenance);
  EXPECT_EQ(atlasKindOf(folder / "packing.h5"), AtlasKind::Packing);
  EXPECT_THAT(refusalOf([&] { (void)readLoadAtlas(folder / "packing.h5"); }),
              HasSubstr("deformations (packing), not of surface loads"));
  EXPECT_THAT(refusalOf([&] { (void)buildAtlas(slab.mesh, slab.sites, atlasPreset("surface-loads")); }),
              HasSubstr("no members"));
}

}  // namespace
}  // namespace falciform::test
