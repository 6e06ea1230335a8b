#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Segmentation/LevelSet.h"
#include "Testing/Logic/Segmentation/PaintedCt.h"

namespace falciform {
namespace {

using test::paintedCt;
using testing::HasSubstr;

/// A ball of 25 mm in fat with a dark nest on its border.
Image nestCt() {
  return paintedCt({50, 50, 40}, {2, 2, 2.5}, 15, 5, [](const Vector3d& at) {
    if ((at - Vector3d(72, 50, 50)).norm() < 8) return -20.0;
    return (at - Vector3d(50, 50, 50)).norm() < 25 ? 100.0 : -90.0;
  });
}

Points oneSeed(const Vector3d& at = {45, 50, 50}) { return Points(at.transpose()); }

LevelSetSettings smallOrgan() {
  LevelSetSettings settings;
  settings.leastVolumeMl = 0;
  return settings;
}

LabelMap emptyMap(const Image& ct) {
  return {ct.size, ct.worldFromIndex, std::vector<std::uint16_t>(ct.voxels.size(), 0)};
}

/// The voxels within `radius` of a place.
LabelMap spot(const Image& ct, const Vector3d& place, double radius) {
  LabelMap map = emptyMap(ct);
  for (int k = 0; k < ct.size.z(); ++k)
    for (int j = 0; j < ct.size.y(); ++j)
      for (int i = 0; i < ct.size.x(); ++i)
        map.at(i, j, k) = (ct.world(Vector3d(i, j, k)) - place).norm() < radius;
  return map;
}

std::string refusalOf(const LevelSetInput& input) {
  try {
    (void)segmentLevelSet(input, smallOrgan());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LevelSetUse, ResultDoesNotDependOnTheNumberOfThreads) {
  const Image ct = nestCt();
  setThreads(1);
  const LabelMap one = segmentLevelSet({.ct = ct, .seeds = oneSeed()}, smallOrgan()).labels;
  setThreads(3);
  const LabelMap three = segmentLevelSet({.ct = ct, .seeds = oneSeed()}, smallOrgan()).labels;
  setThreads(0);
  EXPECT_EQ(one.voxels, three.voxels);
}

TEST(LevelSetUse, FlippedAndPermutedStorageGivesTheSameOrgan) {
  const Image ct = nestCt();
  const LevelSetResult here = segmentLevelSet({.ct = ct, .seeds = oneSeed()}, smallOrgan()),
                       there = segmentLevelSet({.ct = test::storedOtherwise(ct), .seeds = oneSeed()},
                                               smallOrgan());
  EXPECT_EQ(test::storedOtherwise(here.labels).voxels, there.labels.voxels);
  EXPECT_EQ(here.warnings, there.warnings);
}

TEST(LevelSetUse, GoingOnKeepsWhatWasThereAndTakesThePaintedIn) {
  const Image ct = nestCt();
  LabelMap start = segmentLevelSet({.ct = ct, .seeds = oneSeed()}, smallOrgan()).labels;
  const LabelMap nest = spot(ct, {72, 50, 50}, 8);
  const std::vector<std::uint16_t> first = start.voxels;
  for (std::size_t i = 0; i < start.voxels.size(); ++i)
    start.voxels[i] = start.voxels[i] > 0 || nest.voxels[i] > 0;
  const LabelMap after = segmentLevelSet({.ct = ct, .start = &start}, smallOrgan()).labels;
  std::size_t kept = 0, wanted = 0, painted = 0, paintedKept = 0;
  for (std::size_t i = 0; i < start.voxels.size(); ++i) {
    wanted += start.voxels[i];
    kept += start.voxels[i] > 0 && after.voxels[i] > 0;
    painted += nest.voxels[i];
    paintedKept += nest.voxels[i] > 0 && after.voxels[i] > 0;
  }
  // Single voxels at corners may be rounded off by the curvature.
  EXPECT_GT(kept, 0.98 * static_cast<double>(wanted));
  EXPECT_GT(paintedKept, 0.9 * static_cast<double>(painted));
}

TEST(LevelSetUse, ForbiddenVoxelsAreNeverOrgan) {
  const Image ct = nestCt();
  const LabelMap forbidden = spot(ct, {50, 72, 50}, 12);
  const LabelMap organ =
      segmentLevelSet({.ct = ct, .seeds = oneSeed(), .forbidden = &forbidden}, smallOrgan()).labels;
  for (std::size_t i = 0; i < organ.voxels.size(); ++i)
    ASSERT_FALSE(organ.voxels[i] > 0 && forbidden.voxels[i] > 0);
  EXPECT_GT(organ.at(22, 25, 20), 0);
}

TEST(LevelSetUse, PreviewShowsTheFrontOnFinerAndFinerGrids) {
  std::vector<double> voxelMl;
  (void)segmentLevelSet(
      {.ct = nestCt(), .seeds = oneSeed()},
      [] {
        LevelSetSettings settings = smallOrgan();
        settings.coarsestMm = 4;
        return settings;
      }(),
      {},
      [&](const Mask& soFar) {
        EXPECT_GT(countOrgan(soFar), 0u);
        voxelMl.push_back(soFar.voxelVolume());
      });
  EXPECT_GT(voxelMl.size(), 6u) << "the first growth, time steps of 4 mm, of 2 mm";
  EXPECT_TRUE(std::is_sorted(voxelMl.rbegin(), voxelMl.rend())) << "never coarser again";
  EXPECT_EQ(voxelMl[0], voxelMl[1]);
  EXPECT_GT(voxelMl.front(), 3 * voxelMl.back());
}

TEST(LevelSetUse, StopsWhenAskedAtAnyStage) {
  const Image ct = nestCt();
  for (const double stopAt : {0.0, 0.2, 0.5, 0.9}) {
    std::stop_source stop;
    const Progress progress(
        [&](double fraction, std::string_view) {
          if (fraction >= stopAt) stop.request_stop();
        },
        stop.get_token());
    EXPECT_THROW((void)segmentLevelSet({.ct = ct, .seeds = oneSeed()}, smallOrgan(), progress), Cancelled)
        << stopAt;
  }
}

TEST(LevelSetUse, RefusesWhatCannotBeSegmentedInOneLine) {
  const Image ct = nestCt();
  EXPECT_THAT(refusalOf({.ct = ct}), HasSubstr("no seeds"));
  EXPECT_THAT(refusalOf({.ct = ct, .seeds = oneSeed({500, 0, 0})}), HasSubstr("outside the volume"));
  EXPECT_THAT(refusalOf({.ct = ct, .seeds = oneSeed({std::nan(""), 0, 0})}), HasSubstr("outside the volume"));
  Image thin = ct;
  thin.size = {50, 2000, 1};
  EXPECT_THAT(refusalOf({.ct = thin, .seeds = oneSeed()}), HasSubstr("at least 4"));
  const Image air = paintedCt({20, 20, 20}, {3, 3, 3}, 5, 1, [](const Vector3d&) { return -1000.0; });
  EXPECT_THAT(refusalOf({.ct = air, .seeds = oneSeed({30, 30, 30})}), HasSubstr("air"));
  LabelMap other = emptyMap(ct);
  other.worldFromIndex(0, 3) += 1;
  EXPECT_THAT(refusalOf({.ct = ct, .seeds = oneSeed(), .start = &other}), HasSubstr("not the CT's"));
  const LabelMap nothing = emptyMap(ct);
  EXPECT_THAT(refusalOf({.ct = ct, .start = &nothing}), HasSubstr("is empty"));
}

}  // namespace
}  // namespace falciform
