#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/SupportTemplates.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/Support/RealData.h"

namespace falciform::test {
namespace {

constexpr std::uint16_t kCaudate = 1;  // of Couinaud's segments

struct RealLiver {
  const char *update, *couinaud;
};

/// How far `place` is from the nearest voxel of the segment, mm.
double distanceTo(const LabelMap& map, std::uint16_t segment, const Vector3d& place) {
  double nearest = 1e9;
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j)
      for (int i = 0; i < map.size.x(); ++i)
        if (map.at(i, j, k) == segment)
          nearest = std::min(nearest, (map.world(Vector3d(i, j, k)) - place).norm());
  return nearest;
}

class RealSupportSites : public testing::TestWithParam<RealLiver> {};

TEST_P(RealSupportSites, LieBesideTheCaudateLobeAndOnTheSideOfTheirLobe) {
  const auto surfaceFile = std::string("update/") + GetParam().update + "/preop.vtp";
  const auto mapFile = std::string("cohort/couinaud/") + GetParam().couinaud + ".nii.gz";
  FALCIFORM_NEEDS_DATA(surfaceFile);
  FALCIFORM_NEEDS_DATA(mapFile);
  const Surface preop = readSurface(realData() / surfaceFile).value;
  MeshSettings settings;
  settings.edgeLengthMm = 12;
  settings.order = ElementOrder::Linear;
  const TetrahedralMesh mesh = meshLiver(preop, {}, settings).mesh;
  const SupportSites sites = findSupportSites(preop, mesh, boundaryFaces(mesh));
  EXPECT_TRUE(sites.groove.painted);

  std::set<int> seen;
  std::size_t count = 0;
  for (const auto* region :
       {&sites.venaCava, &sites.posteriorBed, &sites.leftUnderside, &sites.rightUnderside}) {
    seen.insert(region->begin(), region->end());
    count += region->size();
    double areaCm2 = 0;
    for (const int f : *region) areaCm2 += sites.areasMm2(f) / 100;
    EXPECT_GT(areaCm2, 15);  // half of what is left for the vena cava on the smallest of them
    EXPECT_LT(areaCm2, 350);
  }
  EXPECT_EQ(seen.size(), count) << "no face is in two regions";

  // The retrohepatic vena cava lies in the angle between caudate and right lobe; it is about 25 mm wide,
  // and in one of these livers runs in a tunnel through it, in front of the place that is found.
  const Vector3d cava = centreOf(sites, sites.venaCava);
  EXPECT_LT(distanceTo(readLabelMap(realData() / mapFile).value, kCaudate, cava), 45) << cava.transpose();
  EXPECT_GT(centreOf(sites, sites.leftUnderside).x(), centreOf(sites, sites.rightUnderside).x() + 40);
  EXPECT_LT(centreOf(sites, sites.posteriorBed).x(), cava.x()) << "the bed is the right lobe's";

  const std::vector<Support> left = leftLobePacked(sites, 20, 25), right = rightLobePacked(sites, 20, 25);
  EXPECT_GT(centreOf(sites, left.back().faces).x(), centreOf(sites, right.back().faces).x() + 40);
}

INSTANTIATE_TEST_SUITE_P(Livers, RealSupportSites,
                         testing::Values(RealLiver{"ircad17_left", "3Dircadb-17"},
                                         RealLiver{"ircad5_left", "3Dircadb-5"},
                                         RealLiver{"ircad8_both", "3Dircadb-8"},
                                         RealLiver{"ircad10_both", "3Dircadb-10"}),
                         [](const auto& liver) { return std::string(liver.param.update); });

}  // namespace
}  // namespace falciform::test
