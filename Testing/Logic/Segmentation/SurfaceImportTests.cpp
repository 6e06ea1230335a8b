#include "Logic/Segmentation/SurfaceImport.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Testing/Logic/Segmentation/LabelMaps.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::gridAxes;
using test::labelWhere;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

LabelMap ballMap(const Matrix3d& axes, const Vector3i& size, double radius) {
  const Vector3d centre = axes * (size.cast<double>() - Vector3d::Ones()) / 2;
  return labelWhere(size, gridAxes(axes), [&](const Vector3d& x) { return (x - centre).norm() < radius; });
}

LabelMap organMap(const Matrix3d& axes, const Vector3i& size) {
  const Vector3d origin = -axes * (size.cast<double>() - Vector3d::Ones()) / 2;
  return labelWhere(size, gridAxes(axes, origin), test::insideOrgan);
}

void expectSound(const SurfaceImportResult& result) {
  EXPECT_TRUE(result.topology.closedManifold()) << describeTopology(result.topology);
  EXPECT_EQ(describeTopology(result.topology), describeTopology(inspectTopology(result.surface)));
  EXPECT_GT(signedVolume(result.surface), 0) << "triangles face outwards";
  EXPECT_NEAR(signedVolume(result.surface), result.surfaceVolumeMm3, 1e-6 * result.voxelVolumeMm3);
  EXPECT_NEAR(result.surfaceVolumeMm3 / result.voxelVolumeMm3, 1, 0.01) << "the promise of the header";
  EXPECT_EQ(result.surface.frame, "LPS");
}

TEST(SurfaceImport, ABallConvergesInAreaAndVolume) {
  constexpr double kRadius = 40, kPi = std::numbers::pi;
  double before = 1;
  for (const double h : {4.0, 2.0, 1.0}) {
    const int n = static_cast<int>(90 / h);
    const SurfaceImportResult result =
        importSurface(ballMap(h * Matrix3d::Identity(), {n, n, n}, kRadius), {});
    expectSound(result);
    const double areaError = std::abs(area(result.surface) / (4 * kPi * kRadius * kRadius) - 1);
    EXPECT_LT(areaError, before) << "at " << h << " mm";
    EXPECT_NEAR(result.surfaceVolumeMm3 / (4 * kPi / 3 * std::pow(kRadius, 3)), 1, 0.02);
    before = areaError;
  }
  EXPECT_LT(before, 0.01) << "raw voxel steps would be 8 % (marching cubes) to 50 % (faces) too large";
}

struct Grid {
  const char* name;
  Matrix3d axes;
  Vector3i size;
};
std::ostream& operator<<(std::ostream& out, const Grid& grid) { return out << grid.name; }

Matrix3d scaled(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

class SurfaceImportOnGrids : public testing::TestWithParam<Grid> {};
INSTANTIATE_TEST_SUITE_P(
    Grids, SurfaceImportOnGrids,
    testing::Values(
        Grid{"isotropic", scaled(2, 2, 2), {90, 60, 50}},
        Grid{"anisotropic", scaled(1.5, 1.5, 5), {120, 80, 20}},
        Grid{"leftHanded", scaled(-2, 2, 2), {90, 60, 50}},
        Grid{"oblique", test::randomMotion(4).linear() * scaled(2, 1.5, 3), {100, 120, 60}},
        Grid{"obliqueLeftHanded", test::randomMotion(9).linear() * scaled(2, 2, -2), {100, 100, 100}}));

TEST_P(SurfaceImportOnGrids, GivesAClosedOutwardSurfaceOfTheVoxelsVolume) {
  const LabelMap map = organMap(GetParam().axes, GetParam().size);
  for (const double edge : {0.0, 4.0}) {
    SurfaceImportSettings settings;
    settings.edgeLengthMm = edge;
    const SurfaceImportResult result = importSurface(map, settings);
    expectSound(result);
    EXPECT_EQ(result.topology.components, 1);
    EXPECT_EQ(result.selectedVoxels,
              static_cast<std::size_t>(std::count(map.voxels.begin(), map.voxels.end(), 1)));
    EXPECT_THAT(result.warnings, testing::IsEmpty());
    if (edge > 0) {
      EXPECT_NEAR(meanEdgeLength(result.surface) / edge, 1, 0.1);
    }
    EXPECT_LT(centroid(result.surface.points).norm(), 15)
        << "mm: the organ stands around the origin, wherever the axes run";
  }
}

Points sorted(const Points& points) {
  std::vector<Vector3d> rows;
  for (Index i = 0; i < points.rows(); ++i) rows.emplace_back(points.row(i).transpose());
  std::sort(rows.begin(), rows.end(), [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  Points result(points.rows(), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) result.row(static_cast<Index>(i)) = rows[i].transpose();
  return result;
}

TEST(SurfaceImport, StorageOrderDoesNotMatter) {
  const Matrix3d tilt = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const LabelMap map = organMap(tilt * scaled(2, 2.2, 3), {100, 60, 40});
  SurfaceImportSettings settings;
  settings.edgeLengthMm = 5;
  const Surface reference = importSurface(map, settings).surface;
  std::array<int, 3> order{0, 1, 2};
  int flips = 0;
  do {
    const std::array<bool, 3> flip{(flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0};
    const Surface other = importSurface(test::stored(map, order, flip), settings).surface;
    ASSERT_EQ(other.size(), reference.size());
    EXPECT_LT((sorted(other.points) - sorted(reference.points)).cwiseAbs().maxCoeff(), 0.01) << "mm";
    EXPECT_GT(signedVolume(other), 0);
    ++flips;
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(CanonicalAxes, KeepEveryVoxelInItsPlaceInTheWorld) {
  LabelMap map = labelWhere({5, 4, 3}, gridAxes(test::randomMotion(2).linear() * scaled(1, 2, 3), {7, 8, 9}),
                            [](const Vector3d&) { return true; });
  for (std::size_t i = 0; i < map.voxels.size(); ++i) map.voxels[i] = static_cast<std::uint16_t>(i);
  const LabelMap turned = canonicalAxes(map);
  const Matrix4d oldFromNew = map.worldFromIndex.inverse() * turned.worldFromIndex;
  for (int k = 0; k < turned.size.z(); ++k)
    for (int j = 0; j < turned.size.y(); ++j)
      for (int i = 0; i < turned.size.x(); ++i) {
        const Eigen::Vector4d old = oldFromNew * Eigen::Vector4d(i, j, k, 1);
        const Vector3i at = old.head<3>().array().round().cast<int>();
        ASSERT_LT((old.head<3>() - at.cast<double>()).norm(), 1e-9);
        EXPECT_EQ(turned.at(i, j, k), map.at(at.x(), at.y(), at.z()));
      }
  const Matrix3d axes = turned.worldFromIndex.topLeftCorner<3, 3>().colwise().normalized();
  EXPECT_GT(axes.diagonal().sum(), 1) << "i, j, k run with L, P, S";
  EXPECT_GT(axes.determinant(), 0);
}

TEST(CanonicalAxes, LeaveACanonicalMapAsItIs) {
  const LabelMap map = organMap(scaled(8, 8, 8), {20, 14, 11});
  const LabelMap turned = canonicalAxes(map);
  EXPECT_EQ(turned.voxels, map.voxels);
  EXPECT_EQ(turned.worldFromIndex, map.worldFromIndex);
}

TEST(SurfaceImport, SelectsTheLabelsAskedFor) {
  LabelMap map = organMap(scaled(3, 3, 3), {60, 40, 34});
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j)
      for (int i = 0; i < map.size.x(); ++i)
        if (map.at(i, j, k) && i > 30) map.at(i, j, k) = 7;
  const auto counts = labelCounts(map);
  ASSERT_EQ(counts.size(), 2u);
  SurfaceImportSettings settings;
  for (const auto& [label, count] : counts) {
    settings.labels = {label};
    EXPECT_EQ(importSurface(map, settings).selectedVoxels, count);
  }
  settings.labels = {7, 1};
  EXPECT_EQ(importSurface(map, settings).selectedVoxels, counts[0].second + counts[1].second);
  settings.labels = {};
  EXPECT_EQ(importSurface(map, settings).selectedVoxels, counts[0].second + counts[1].second);

  settings.labels = {9};
  try {
    (void)importSurface(map, settings);
    FAIL() << "label 9 is not there";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("label 9 is not in the map; choose from 1 (" + std::to_string(counts[0].second)));
  }
}

TEST(SurfaceImport, StopsWhenAsked) {
  std::stop_source stop;
  const auto sink = [&](double fraction, std::string_view) {
    if (fraction > 0.3) stop.request_stop();
  };
  SurfaceImportSettings settings;
  settings.edgeLengthMm = 4;
  EXPECT_THROW((void)importSurface(organMap(scaled(3, 3, 3), {60, 40, 34}), settings,
                                   Progress(sink, stop.get_token())),
               Cancelled);
}

}  // namespace
}  // namespace falciform
