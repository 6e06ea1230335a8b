#include <gmock/gmock.h>

#include <set>

#include "Logic/Atlas/AtlasDesign.h"
#include "Logic/Atlas/AtlasMembers.h"
#include "Logic/Atlas/DesignSampling.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/SlabLiver.h"

namespace falciform::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string refusalOf(const std::string& text) {
  try {
    (void)designFromJson(json::parse(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AtlasDesign, PresetsHoldTheThesissValues) {
  const AtlasDesign gravity = atlasPreset("thesis-gravity"), packing = atlasPreset("thesis-packing");
  EXPECT_EQ(gravity.liver.youngsModulusKPa, 15);
  EXPECT_EQ(gravity.liver.poissonsRatio, 0.47);
  EXPECT_EQ(gravity.liver.densityKgPerM3, 1000);
  EXPECT_EQ(packing.liver.youngsModulusKPa, 270);
  EXPECT_EQ(packing.liver.densityKgPerM3, 1040);
  const SlabLiver slab = slabLiver();
  const AtlasMembers turned = membersOf(gravity, slab.sites), packed = membersOf(packing, slab.sites);
  EXPECT_EQ(turned.members.size(), 121u);
  EXPECT_EQ(turned.setups.size(), 1u);
  EXPECT_EQ(packed.members.size(), 180u);
  EXPECT_EQ(packed.setups.size(), 20u);
  std::set<double> pushes;
  for (const AtlasMember& member : packed.members) pushes.insert(member.pushMm);
  EXPECT_THAT(pushes, testing::ElementsAre(5, 10, 15, 20, 25, 30, 35, 40, 45));
}

TEST(AtlasDesign, APackPressesFromOneSide) {
  SlabLiver slab = slabLiver();
  // The front is called underside as well: a place at the edge would reach around it.
  for (Index f = 0; f < slab.faces.size(); ++f)
    if (slab.sites.centres(f, 1) < 1e-9) slab.sites.leftUnderside.push_back(static_cast<int>(f));
  AtlasDesign design = atlasPreset("thesis-packing");
  design.packing = {.places = 8, .extentMm = 40, .stepMm = 5, .maxPushMm = 5};
  for (const AtlasSetup& setup : membersOf(design, slab.sites).setups) {
    const std::vector<int>& pushed = setup.supports[static_cast<std::size_t>(setup.pushed)].faces;
    ASSERT_FALSE(pushed.empty());
    const bool under = slab.sites.centres(pushed.front(), 2) < 1e-9;
    for (const int face : pushed) EXPECT_EQ(slab.sites.centres(face, 2) < 1e-9, under);
  }
}

TEST(AtlasDesign, GravityIsTurnedAboutTheYThenTheZAxis) {
  const AtlasMembers turned = membersOf(atlasPreset("thesis-gravity"), slabLiver().sites);
  const double half = std::sqrt(0.5), c = std::cos(50 * EIGEN_PI / 180), s = std::sin(50 * EIGEN_PI / 180);
  // About y by -50 degrees: (x c, y, x s); then about z by -50 degrees.
  const Vector3d once(half * c, half, half * s);
  const Vector3d wanted = 9.81 * Vector3d(once[0] * c + once[1] * s, -once[0] * s + once[1] * c, once[2]);
  EXPECT_LT((turned.members.front().gravityMPerS2 - wanted).norm(), 1e-12);  // m/s2, rounding
  const Vector3d initial = 9.81 * Vector3d(half, half, 0);
  for (const AtlasMember& member : turned.members) {
    EXPECT_NEAR(member.gravityMPerS2.norm(), 9.81, 1e-12);
    EXPECT_LT((member.gravityChangeMPerS2 - (member.gravityMPerS2 - initial)).norm(), 1e-12);
  }
  EXPECT_EQ(turned.members[60].gravityChangeMPerS2.norm(), 0);  // both angles 0: as at the CT
  AtlasDesign printed = atlasPreset("thesis-gravity");
  printed.gravityDirections.changeOnly = false;
  const AtlasMembers whole = membersOf(printed, slabLiver().sites);
  EXPECT_EQ(whole.members[60].gravityChangeMPerS2, whole.members[60].gravityMPerS2);
}

TEST(AtlasDesign, SamplesStayInTheirRangesAndCoverThem) {
  AtlasDesign design;
  design.kind = AtlasKind::Sampled;
  design.sampled = {.members = 60,
                    .setups = 20,
                    .minExtentMm = 10,
                    .maxExtentMm = 30,
                    .minPushMm = 5,
                    .maxPushMm = 25,
                    .maxTurnDeg = 30,
                    .minStiffnessRatio = 1,
                    .maxStiffnessRatio = 4,
                    .stiffnessLevels = 3};
  design.supportSets.push_back({"lifted", {"venaCava"}, {}});
  const SlabLiver slab = slabLiver(true);
  const AtlasMembers drawn = membersOf(design, slab.sites);
  ASSERT_EQ(drawn.members.size(), 60u);
  ASSERT_EQ(drawn.setups.size(), 20u);
  std::set<int> pushSlices;
  for (const AtlasMember& member : drawn.members) {
    EXPECT_GE(member.gravityMPerS2[1], 9.81 * std::cos(30 * EIGEN_PI / 180) - 1e-12);
    pushSlices.insert(static_cast<int>((member.pushMm - 5) / 20 * 60));
  }
  EXPECT_EQ(pushSlices.size(), 60u);  // one in every slice
  std::set<int> extentSlices;
  std::map<double, int> ratios;
  std::map<std::string, int> sets;
  for (const AtlasSetup& setup : drawn.setups) {
    extentSlices.insert(static_cast<int>((setup.extentMm - 10) / 20 * 20));
    ++ratios[setup.stiffnessRatio];
    ++sets[setup.name];
  }
  EXPECT_EQ(extentSlices.size(), 20u);
  ASSERT_EQ(ratios.size(), 3u);
  EXPECT_NEAR(std::next(ratios.begin())->first, 2, 1e-12);  // evenly by logarithm
  EXPECT_EQ(sets.size(), 2u);
  const AtlasMembers again = membersOf(design, slab.sites);
  design.seed = 2;
  const AtlasMembers other = membersOf(design, slab.sites);
  EXPECT_EQ(again.members[7].pushMm, drawn.members[7].pushMm);
  EXPECT_NE(other.members[7].pushMm, drawn.members[7].pushMm);
}

TEST(AtlasDesign, ReadsBackWhatItWrites) {
  AtlasDesign design = designFromJson(json::parse(
      R"({"kind": "sampled", "seed": 9, "energy": 0.999, "liver": {"youngsModulusKPa": 3},
          "sampled": {"members": 50, "setups": 10, "maxPushMm": 12.5},
          "supportSets": [{"name": "a", "fixed": ["venaCava"]}, {"fixed": ["posteriorBed"]}]})"));
  EXPECT_EQ(design.seed, 9u);
  EXPECT_EQ(design.liver.youngsModulusKPa, 3);
  EXPECT_EQ(design.sampled.maxPushMm, 12.5);
  EXPECT_EQ(design.sampled.minExtentMm, SampledDesignSettings{}.minExtentMm);
  EXPECT_EQ(design.supportSets[1].name, "support set 2");
  EXPECT_EQ(toJson(designFromJson(toJson(design))), toJson(design));
  const AtlasDesign overlaid =
      designFromJson(json::parse(R"({"preset": "thesis-packing", "packing": {"places": 4}})"));
  EXPECT_EQ(overlaid.packing.places, 4);
  EXPECT_EQ(overlaid.liver.youngsModulusKPa, 270);
}

TEST(AtlasDesign, FaultsAreNamedInOneLine) {
  EXPECT_THAT(refusalOf("[]"), HasSubstr("no JSON object"));
  EXPECT_THAT(refusalOf("{}"), HasSubstr("neither 'kind' nor 'preset'"));
  EXPECT_THAT(refusalOf(R"({"kind": "gravity"})"),
              HasSubstr("gravityDirections, packing, sampled or surfaceLoads"));
  EXPECT_THAT(refusalOf(R"({"preset": "thesis"})"),
              HasSubstr("thesis-gravity, thesis-packing or surface-loads"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "placs": 3})"), HasSubstr("no key 'placs'"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "packing": {"placs": 3}})"),
              testing::AllOf(HasSubstr("'packing'"), HasSubstr("no key 'placs'")));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "sampled": {}})"), HasSubstr("settings of 'sampled'"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "packing": {"places": 0}})"), HasSubstr("places"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "packing": {"places": 1e300}})"), HasSubstr("places"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "packing": {"stepMm": 50}})"), HasSubstr("exchange them"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "packing": {"stepMm": 0.1, "places": 1000}})"),
              HasSubstr("450000 members"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "liver": {"poissonsRatio": 0.5}})"),
              testing::AllOf(HasSubstr("'liver'"), HasSubstr("poissonsRatio")));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "energy": 2})"), HasSubstr("energy"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "seed": -1})"), HasSubstr("seed"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "supportSets": []})"), HasSubstr("supportSets"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "supportSets": [{"fixed": ["spleen"]}]})"),
              HasSubstr("region 'spleen'; choose venaCava"));
  EXPECT_THAT(refusalOf(R"({"kind": "packing", "supportSets": [{"name": "air"}]})"), HasSubstr("no region"));
  EXPECT_THAT(
      refusalOf(R"({"kind": "gravityDirections", "gravityDirections": {"initialX": 0, "initialY": 0}})"),
      HasSubstr("no direction"));
  EXPECT_THAT(refusalOf(R"({"kind": "sampled", "sampled": {"members": 3, "setups": 9}})"),
              HasSubstr("9 setups for 3 members"));
}

TEST(LatinHypercube, HasOnePointInEverySliceOfEveryAxis) {
  const Eigen::MatrixXd points = latinHypercube(50, 4, 3, 0);
  for (Index axis = 0; axis < 4; ++axis) {
    std::set<int> slices;
    for (Index k = 0; k < 50; ++k) slices.insert(static_cast<int>(points(k, axis) * 50));
    EXPECT_EQ(slices.size(), 50u);
    EXPECT_EQ(*slices.rbegin(), 49);
  }
}

}  // namespace
}  // namespace falciform::test
