#include <gtest/gtest.h>

#include <limits>

#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/MapGalleryScene.h"
#include "Widgets/Rendering/MappedCase.h"

namespace falciform::test {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

TEST(MapMetric, NameUnitAndSignFollowFromTheArray) {
  EXPECT_EQ(metricOf(kSignedDistance, true).title, "Signed distance");
  EXPECT_EQ(metricOf(kSignedDistance, true).unit, "mm");
  EXPECT_EQ(metricOf(kCurvatureDifference, false).title, "Mean-curvature difference");
  EXPECT_EQ(metricOf(kCurvatureDifference, false).unit, "1/mm");
  EXPECT_EQ(metricOf("surface_turn_deg", false).title, "Surface turn");
  EXPECT_EQ(metricOf("surface_turn_deg", false).unit, "deg");
  EXPECT_EQ(metricOf("share", false).unit, "");
  EXPECT_TRUE(metricOf("share", false).meaning.empty()) << "nobody knows what its sign means";
}

TEST(MapMetric, AMapOffersAllItsArraysButSegmentsLiverFirstDistanceFirst) {
  DistanceMap map;
  map.preop = sphere(10, 1);
  map.scan = map.preop;
  for (const char* array : {"aaa_mm", kSignedDistance, kCurvatureDifference, kCouinaudSegment})
    map.preop.arrays[array] = VectorXd::Zero(map.preop.size());
  map.scan.arrays[kSignedDistance] = VectorXd::Zero(map.scan.size());
  const std::vector<MapMetric> metrics = metricsOf(map);
  ASSERT_EQ(metrics.size(), 4u);
  EXPECT_EQ(metrics[0].array, kSignedDistance);
  EXPECT_EQ(metrics[1].array, kCurvatureDifference);
  EXPECT_EQ(metrics[2].array, "aaa_mm");
  EXPECT_TRUE(metrics[3].onScan);
}

TEST(ScalarMap, TheAutomaticEndHolds98PercentAndPassesOverStrayAndMissingValues) {
  VectorXd values = VectorXd::LinSpaced(1000, -4, 4);
  values[0] = -900;
  values[1] = kNoValue;
  values[2] = std::numeric_limits<double>::infinity();
  const double end = symmetricEnd(values);
  EXPECT_EQ(end, 4) << "3.9 rounded up; not 900";
  EXPECT_GE((values.array().abs() <= end).count(), 0.98 * 998);
  EXPECT_EQ(symmetricEnd(VectorXd()), 1);
  EXPECT_EQ(symmetricEnd(VectorXd::Constant(3, kNoValue)), 1);
}

TEST(ScalarMap, UnevenEndsLeaveZeroInTheMiddleOfTheColours) {
  const ScalarMap even{"d", "", "mm", -8, 8}, uneven{"d", "", "mm", -3, 8};
  for (const double value : {-3.0, -1.0, 0.0, 2.0, 8.0})
    EXPECT_EQ(colourOf(uneven, value), colourOf(even, value)) << value;
  EXPECT_EQ(colourOf(uneven, -3.1), kOffScaleColour);
  EXPECT_NE(colourOf(uneven, 0.1), kOffScaleColour);
}

TEST(ScalarMap, OnlyValuesBelowTheThresholdArePale) {
  ScalarMap map{"d", "", "mm", -8, 8};
  EXPECT_NE(colourOf(map, 0), kBelowThresholdColour) << "none by default";
  map.threshold = 2;
  EXPECT_EQ(colourOf(map, 1.99), kBelowThresholdColour);
  EXPECT_EQ(colourOf(map, -1.99), kBelowThresholdColour);
  EXPECT_NE(colourOf(map, 2), kBelowThresholdColour);
  EXPECT_EQ(colourOf(map, kNoValue), kNoValueColour) << "not covered is not small";
  EXPECT_EQ(colourOf(map, 9), kOffScaleColour);
}

TEST(TileGrid, HoldsAllTilesAndNoGridHasLargerOnes) {
  constexpr double kCaptionPx = 40;
  for (const auto& [width, height] : {std::pair{1600.0, 1200.0}, {900.0, 1600.0}, {4000.0, 1300.0}})
    for (int tiles = 1; tiles <= 30; ++tiles) {
      const TileGrid grid = tileGrid(tiles, width, height, kCaptionPx);
      EXPECT_GE(grid.columns * grid.rows, tiles);
      const auto size = [&](int columns, int rows) {
        // The height of a 4:3 picture below the caption.
        return std::min(width / columns * 3 / 4, height / rows - kCaptionPx);
      };
      for (int columns = 1; columns <= tiles; ++columns) {
        const int rows = (tiles + columns - 1) / columns;  // more would only be smaller
        EXPECT_LE(size(columns, rows), size(grid.columns, grid.rows) + 1e-6) << tiles;
      }
    }
}

}  // namespace
}  // namespace falciform::test
