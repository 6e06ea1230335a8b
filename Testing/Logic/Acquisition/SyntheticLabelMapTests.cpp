#include <gtest/gtest.h>

#include <map>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Logic/Acquisition/SyntheticLivers.h"

namespace falciform {
namespace {

const LabelMap& coarseMap() {
  static const LabelMap map = [] {
    SyntheticLiverSettings settings;
    settings.voxelMm = 3;
    return makeSyntheticLabelMap(settings);
  }();
  return map;
}

std::map<int, double> volumes(const LabelMap& map) {
  std::map<int, double> result;
  for (const std::uint16_t label : map.voxels) result[label] += map.voxelVolume();
  return result;
}

TEST(SyntheticLabelMap, HasTheSurfacesVolumeAndTheStructures) {
  auto found = volumes(coarseMap());
  const SyntheticLiver& liver = test::defaultLiver();
  const double whole = found[synthetic::kLiver] + found[synthetic::kTumour] + found[synthetic::kPortalVein] +
                       found[synthetic::kHepaticVein];
  EXPECT_NEAR(whole, signedVolume(liver.surface), 0.01 * whole);
  // Voxels of 3 mm against tubes of 5 mm: 10 %.
  const double tumours =
      signedVolume(liver.structures.at("tumour 1")) + signedVolume(liver.structures.at("tumour 2"));
  EXPECT_NEAR(found[synthetic::kTumour], tumours, 0.1 * tumours);
  EXPECT_NEAR(found[synthetic::kPortalVein], signedVolume(liver.structures.at("portal vein")),
              0.1 * found[synthetic::kPortalVein]);
  EXPECT_NEAR(found[synthetic::kHepaticVein], signedVolume(liver.structures.at("hepatic vein")),
              0.1 * found[synthetic::kHepaticVein]);
}

TEST(SyntheticLabelMap, VoxelCentresAgreeWithTheSurfaceInTheWorld) {
  const LabelMap& map = coarseMap();
  EXPECT_NEAR((map.spacing() - Vector3d::Constant(3)).norm(), 0, 1e-12);
  const TriangleTree tree(test::defaultLiver().surface);
  int compared = 0;
  for (std::size_t n = 0; n < map.voxels.size(); n += 97) {
    const int i = static_cast<int>(n) % map.size.x(), j = static_cast<int>(n) / map.size.x() % map.size.y(),
              k = static_cast<int>(n) / (map.size.x() * map.size.y());
    const ClosestPlace place = tree.closest(map.world(Vector3d(i, j, k)));
    if (place.distance < 0.2) continue;  // mm; the triangles' chords
    EXPECT_EQ(map.voxels[n] > 0, place.side < 0) << i << ' ' << j << ' ' << k;
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST(SyntheticLabelMap, NamesWhatLiesAtTheTargets) {
  const LabelMap& map = coarseMap();
  const auto labelAt = [&](const Vector3d& p) {
    const Vector3d index = (map.worldFromIndex.inverse() * p.homogeneous()).head<3>();
    return map.at(static_cast<int>(std::lround(index.x())), static_cast<int>(std::lround(index.y())),
                  static_cast<int>(std::lround(index.z())));
  };
  for (const Landmark& target : test::coarseLiver().targets.points) {
    const int found = labelAt(target.position);
    const bool tumour = target.name.starts_with("tumour");
    EXPECT_EQ(found == synthetic::kTumour, tumour) << target.name;
    if (target.name == "portal bifurcation") {
      EXPECT_EQ(found, synthetic::kPortalVein);
    }
    if (target.name == "hepatic vein confluence") {
      EXPECT_EQ(found, synthetic::kHepaticVein);
    }
    EXPECT_GT(labelAt(target.position), 0) << target.name;
  }
}

TEST(SyntheticLabelMap, LeavesAirAllAround) {
  const LabelMap& map = coarseMap();
  int atTheRim = 0;
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j)
      for (int i = 0; i < map.size.x(); ++i) {
        const Eigen::Array3i index(i, j, k);
        const bool rim = (index < 2).any() || (index >= map.size.array() - 2).any();
        atTheRim += rim && map.at(i, j, k) > 0;
      }
  EXPECT_EQ(atTheRim, 0);
}

TEST(SyntheticLabelMap, IsTheSameWithAnyNumberOfThreads) {
  SyntheticLiverSettings settings;
  settings.voxelMm = 6;
  settings.variation = 0.1;
  setThreads(1);
  const LabelMap one = makeSyntheticLabelMap(settings);
  setThreads(3);
  const LabelMap three = makeSyntheticLabelMap(settings);
  setThreads(0);
  EXPECT_EQ(one.voxels, three.voxels);
}

}  // namespace
}  // namespace falciform
