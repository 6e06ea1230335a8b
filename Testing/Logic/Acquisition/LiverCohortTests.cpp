#include <gtest/gtest.h>

#include "Logic/Acquisition/LiverStructures.h"
#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {
namespace {

SyntheticLiverSettings cohortMember(int seed) {
  SyntheticLiverSettings settings;
  settings.edgeLengthMm = 7;
  settings.voxelMm = 4;
  settings.variation = 0.2;
  settings.seed = seed;
  return settings;
}

class LiverCohort : public testing::TestWithParam<int> {};

TEST_P(LiverCohort, EachMemberIsAPlausibleLiver) {
  const SyntheticLiver liver = makeSyntheticLiver(cohortMember(GetParam()));
  const TopologyReport report = inspectTopology(liver.surface);
  EXPECT_TRUE(report.closedManifold()) << describeTopology(report);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.eulerCharacteristic, 2);
  const double millilitres = signedVolume(liver.surface) / 1000;
  EXPECT_GT(millilitres, 900);  // the span of adult livers
  EXPECT_LT(millilitres, 2800);
  EXPECT_GE(pointsOfPatch(liver.surface, patch::kFalciform).size(), 10u);  // a vertex stands for 40 mm2
  EXPECT_GE(pointsOfPatch(liver.surface, patch::kInferiorRidge).size(), 25u);
  const TriangleTree tree(liver.surface);
  for (const auto& [name, structure] : liver.structures) {
    EXPECT_TRUE(inspectTopology(structure).closedManifold()) << name;
    for (Index i = 0; i < structure.size(); ++i) {
      const ClosestPlace place = tree.closest(structure.points.row(i).transpose());
      ASSERT_TRUE(place.side < 0) << name << " comes out by " << place.distance << " mm";
    }
  }
  for (const Landmark& target : liver.targets.points)
    EXPECT_LT(tree.closest(target.position).side, 0) << target.name;
}

INSTANTIATE_TEST_SUITE_P(Seeds, LiverCohort, testing::Range(1, 11));

TEST(LiverCohort, SeedsDifferOnlyWhereVariationIsAskedFor) {
  SyntheticLiverSettings a = cohortMember(1), b = cohortMember(2);
  const SyntheticLiver first = makeSyntheticLiver(a), second = makeSyntheticLiver(b);
  EXPECT_GT(std::abs(signedVolume(first.surface) - signedVolume(second.surface)), 10000);  // mm3
  a.variation = b.variation = 0;
  const SyntheticLiver plain = makeSyntheticLiver(a), same = makeSyntheticLiver(b);
  EXPECT_TRUE(plain.surface.points == same.surface.points);
}

TEST(LiverCohort, ExtremeSettingsStillGiveAClosedLiverWithItsInsideInside) {
  SyntheticLiverSettings small;
  small.widthMm = 100, small.depthMm = 60, small.heightMm = 60, small.edgeLengthMm = 4;
  SyntheticLiverSettings large;
  large.widthMm = 400, large.depthMm = 300, large.heightMm = 300, large.edgeLengthMm = 15,
  large.domeShare = 1.4;
  SyntheticLiverSettings deep;
  deep.grooveDepthMm = 15, deep.fossaDepthMm = 20, deep.ridgeRadiusMm = 1, deep.leftLobeShare = 0.2,
  deep.edgeLengthMm = 5;
  SyntheticLiverSettings plain;
  plain.grooveDepthMm = 0, plain.fossaDepthMm = 0, plain.ridgeRadiusMm = 15, plain.leftLobeShare = 0.6,
  plain.domeShare = 0.6, plain.edgeLengthMm = 5;
  for (const SyntheticLiverSettings& settings : {small, large, deep, plain}) {
    const SyntheticLiver liver = makeSyntheticLiver(settings);
    EXPECT_TRUE(inspectTopology(liver.surface).closedManifold())
        << describeTopology(inspectTopology(liver.surface));
    EXPECT_EQ(inspectTopology(liver.surface).components, 1);
    EXPECT_EQ(patchLabels(liver.surface).size(), 2u);
    const LiverShape shape(settings);
    for (const auto& [name, structure] : liver.structures)
      for (Index i = 0; i < structure.size(); ++i)
        ASSERT_LT(shape.distance(structure.points.row(i).transpose()), 0) << name;
  }
}

}  // namespace
}  // namespace falciform
