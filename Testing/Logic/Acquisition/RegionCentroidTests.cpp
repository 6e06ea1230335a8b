#include "Logic/Acquisition/RegionCentroid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr double kAir = -1000, kTeflon = 950, kHalf = -25;

/// 40^3 voxels, each the share of a body that `share` says for its index.
Image volume(const Matrix4d& worldFromIndex, const std::function<double(const Vector3d&)>& share) {
  Image image;
  image.size = {40, 40, 40};
  image.worldFromIndex = worldFromIndex;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        image.voxels.push_back(static_cast<float>(kAir + (kTeflon - kAir) * share(Vector3d(i, j, k))));
  return image;
}

Matrix4d cubic(double mm) {
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() *= mm;
  m.topRightCorner<3, 1>() << -31.3, 17.9, 255.1;
  return m;
}

/// Share of voxel `index` in the ball about `centre` (mm, by `worldFromIndex`): 6^3 samples.
double ballShare(const Matrix4d& worldFromIndex, const Vector3d& index, const Vector3d& centre,
                 double radius) {
  constexpr int kSamples = 6;
  int in = 0;
  for (int n = 0; n < kSamples * kSamples * kSamples; ++n) {
    const Vector3d part(n % kSamples, n / kSamples % kSamples, n / (kSamples * kSamples));
    const Vector3d at = index + ((part.array() + 0.5) / kSamples - 0.5).matrix();
    in += ((worldFromIndex * at.homogeneous()).head<3>() - centre).norm() < radius;
  }
  return static_cast<double>(in) / (kSamples * kSamples * kSamples);
}

Image ball(const Matrix4d& worldFromIndex, const Vector3d& centre, double radius) {
  return volume(worldFromIndex,
                [&](const Vector3d& index) { return ballShare(worldFromIndex, index, centre, radius); });
}

/// Share of [low, high] that a voxel at `at` sees, one voxel's edge to either side with a linearly falling
/// weight.
double seen(double low, double high, double at) {
  const auto below = [&](double end) {  // integral of the weight up to `end`
    const double x = std::clamp(end - at, -1.0, 1.0);
    return x < 0 ? 0.5 * (1 + x) * (1 + x) : 1 - 0.5 * (1 - x) * (1 - x);
  };
  return below(high) - below(low);
}

TEST(GrowRegion, CentreOfABoxBetweenVoxelsIsExact) {
  // Linear weights reproduce linear moments on a grid, so that the sum over voxels is the box's own centre.
  const Vector3d low(9.3, 11.71, 8.05), high(22.9, 19.4, 30.6);
  const Image image = volume(cubic(0.8), [&](const Vector3d& at) {
    double share = 1;
    for (int a = 0; a < 3; ++a) share *= seen(low[a], high[a], at[a]);
    return share;
  });
  const Vector3d middle = image.world(0.5 * (low + high));
  const GrownRegion found = growRegion(image, middle, kHalf, 1e5);
  EXPECT_LT((found.centre - middle).norm(), 1e-5);  // mm: voxels are floats
  EXPECT_NEAR(found.volumeMm3, (high - low).prod() * 0.512, 1e-2);
}

TEST(GrowRegion, CentreOfABallHasNoBiasFromTheGrid) {
  Draws draws(5);
  for (int n = 0; n < 6; ++n) {
    const Matrix4d grid = cubic(1.1);
    const Vector3d centre = (grid * Eigen::Vector4d(19.5 + draws.uniform(-1, 1), 19.5 + draws.uniform(-1, 1),
                                                    19.5 + draws.uniform(-1, 1), 1))
                                .head<3>();
    const GrownRegion found = growRegion(ball(grid, centre, 12.7), centre + Vector3d(3, -4, 2), kHalf, 1e5);
    EXPECT_LT((found.centre - centre).norm(), 0.005);  // mm: 216 samples a voxel; a voxel is 1.1 mm
    EXPECT_NEAR(found.volumeMm3, 4.0 / 3 * M_PI * std::pow(12.7, 3), 0.003 * 8580);
  }
}

TEST(GrowRegion, WorksOnObliqueAnisotropicLeftHandedGrids) {
  Matrix4d grid = Matrix4d::Identity();
  grid.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.4, Vector3d(1, 2, 0.5).normalized()).toRotationMatrix() *
                               Vector3d(0.9, 0.7, -1.6).asDiagonal();
  grid.topRightCorner<3, 1>() << 12, -40, 7;
  const Vector3d centre = (grid * Eigen::Vector4d(19.2, 20.7, 18.9, 1)).head<3>();
  const GrownRegion found = growRegion(ball(grid, centre, 9), centre, kHalf, 1e5);
  EXPECT_LT((found.centre - centre).norm(), 0.01);  // mm
}

TEST(GrowRegion, NoiseAveragesOut) {
  const Vector3d centre = cubic(1).topRightCorner<3, 1>() + Vector3d(19.4, 20.1, 19.8);
  Image image = ball(cubic(1), centre, 10);
  Draws draws(3);
  for (float& value : image.voxels) value += static_cast<float>(40 * draws.normal());
  // About 7,900 voxels, at 7 mm from the middle along an axis, each off by 40 of 1950 HU: 0.003 mm.
  EXPECT_LT((growRegion(image, centre, kHalf, 1e5).centre - centre).norm(), 0.02);
}

TEST(GrowRegion, LeavesANeighbourAlone) {
  const Matrix4d grid = cubic(1);
  const Vector3d here = grid.topRightCorner<3, 1>() + Vector3d(11, 20, 20), there = here + Vector3d(17, 0, 0);
  const Image image = volume(grid, [&](const Vector3d& index) {
    return ballShare(grid, index, here, 6) + ballShare(grid, index, there, 6);  // 5 mm of air between
  });
  EXPECT_LT((growRegion(image, here, kHalf, 1e5).centre - here).norm(), 0.01);  // mm
  EXPECT_LT((growRegion(image, there, kHalf, 1e5).centre - there).norm(), 0.01);
}

TEST(FindBodies, TakesThoseOfTheRightSizeAndNoOthers) {
  const Matrix4d grid = cubic(1);
  const Vector3d origin = grid.topRightCorner<3, 1>();
  const std::vector<std::pair<Vector3d, double>> balls{{origin + Vector3d(9, 9, 9), 4},
                                                       {origin + Vector3d(28.3, 11.7, 10.2), 5},
                                                       {origin + Vector3d(20, 25, 27), 9}};
  const Image image = volume(grid, [&](const Vector3d& index) {
    double share = 0;
    for (const auto& [centre, radius] : balls) share += ballShare(grid, index, centre, radius);
    return share;
  });
  const auto found = findBodies(image, kHalf, 200, 700);  // balls of 268, 524 and 3054 mm3
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT((found[0].centre - balls[1].first).norm() * (found[0].centre - balls[0].first).norm(), 0.2);
  for (const GrownRegion& body : found) {
    const double nearest =
        std::min((body.centre - balls[0].first).norm(), (body.centre - balls[1].first).norm());
    EXPECT_LT(nearest, 0.01);  // mm
    // From any seed in it, the same body.
    const GrownRegion grown = growRegion(image, body.centre, kHalf, 1e5);
    EXPECT_LT((grown.centre - body.centre).norm(), 1e-9);
    EXPECT_EQ(grown.voxels, body.voxels);
  }
  EXPECT_EQ(findBodies(image, kHalf, 0, 1e5).size(), 3u);
  EXPECT_TRUE(findBodies(image, 2000, 0, 1e5).empty());
  EXPECT_EQ(findBodies(image, kAir - 1, 0, 1e9).size(), 1u);  // all of it
}

TEST(GrowRegion, SaysWhatIsWrongWithASeed) {
  const Vector3d centre = cubic(1).topRightCorner<3, 1>() + Vector3d(20, 20, 20);
  const Image image = ball(cubic(1), centre, 8);
  EXPECT_THROW((void)growRegion(image, centre + Vector3d(100, 0, 0), kHalf, 1e5), InputError);
  EXPECT_THROW((void)growRegion(image, Vector3d::Constant(std::nan("")), kHalf, 1e5), InputError);
  EXPECT_THROW((void)growRegion(image, centre + Vector3d(12, 0, 0), kHalf, 1e5), InputError);  // in the air
  EXPECT_THROW((void)growRegion(image, centre, kHalf, 500), InputError);     // a leak, were this its size
  EXPECT_THROW((void)growRegion(image, centre, kAir - 1, 1e4), InputError);  // all is above the threshold
}

}  // namespace
}  // namespace falciform
