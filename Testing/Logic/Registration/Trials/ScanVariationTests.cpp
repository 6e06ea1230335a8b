#include "Logic/Registration/Trials/ScanVariation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

const Surface kScan = test::lumpyBody(4);  // 2562 points, a few per cent of them in two patches
const auto kPoints = static_cast<double>(kScan.size());

/// Four standard deviations of a share of n draws: one seed in 16,000 fails a right sampler; ours is fixed.
double tolerance(double share, double n) { return 4 * std::sqrt(share * (1 - share) / n); }

std::size_t labelled(const Surface& scan, int label) { return pointsOfPatch(scan, label).size(); }

TEST(ScanVariation, NothingAskedForIsTheScanItself) {
  const Surface same = variedScan(kScan, {}, 1, 1);
  EXPECT_EQ(same.points, kScan.points);
  EXPECT_EQ(same.patch, kScan.patch);
  EXPECT_EQ(same.triangles, kScan.triangles);
}

TEST(ScanVariation, ThinningKeepsItsShareAndWhatStaysIsAsItWas) {
  const Surface thin = variedScan(kScan, {.keepShare = 0.6}, 1, 1);
  EXPECT_NEAR(static_cast<double>(thin.size()) / kPoints, 0.6, tolerance(0.6, kPoints));
  EXPECT_EQ(thin.patch.size(), static_cast<std::size_t>(thin.size()));
  EXPECT_NO_THROW(checkSurface(thin, "thin scan"));
  Index at = 0;  // in the order of the scan, each with its label
  for (Index i = 0; i < kScan.size() && at < thin.size(); ++i)
    if (thin.points.row(at) == kScan.points.row(i)) {
      EXPECT_EQ(thin.patchAt(at), kScan.patchAt(i));
      ++at;
    }
  EXPECT_EQ(at, thin.size());
}

TEST(ScanVariation, NoiseHasItsStandardDeviationAndNoMean) {
  const Points noise = variedScan(kScan, {.noiseMm = 2}, 1, 1).points - kScan.points;
  const double n = 3 * kPoints;
  EXPECT_NEAR(noise.mean(), 0, 4 * 2 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(noise.squaredNorm() / n), 2, 4 * 2 / std::sqrt(2 * n));
}

TEST(ScanVariation, OutliersAreTheirShareAndFarOff) {
  const VectorXd moved =
      (variedScan(kScan, {.outlierShare = 0.3}, 1, 1).points - kScan.points).rowwise().norm();
  const auto share = static_cast<double>((moved.array() > 0).count()) / kPoints;
  EXPECT_NEAR(share, 0.3, tolerance(0.3, kPoints));
  for (const double distance : moved)
    if (distance > 0) {
      EXPECT_GE(distance, 10 - 1e-9);
      EXPECT_LE(distance, 50 + 1e-9);
    }
}

TEST(ScanVariation, MislabelledPointsAreTheirShareAndEachPatchKeepsItsSize) {
  const Surface wrong = variedScan(kScan, {.mislabelShare = 0.4}, 1, 1);
  double lost = 0, painted = 0;
  for (Index i = 0; i < kScan.size(); ++i) {
    painted += kScan.patchAt(i) > 0 ? 1 : 0;
    lost += kScan.patchAt(i) > 0 && wrong.patchAt(i) != kScan.patchAt(i) ? 1 : 0;
  }
  // Some give it to a point that had the same label: the patches' share of the scan, below 5 %.
  EXPECT_NEAR(lost / painted, 0.4, tolerance(0.4, painted) + 0.4 * 0.05);
  for (const int label : {1, 2}) EXPECT_EQ(labelled(wrong, label), labelled(kScan, label));
  EXPECT_EQ(wrong.points, kScan.points);
}

TEST(ScanVariation, EachTrialIsItsOwnAndAlwaysTheSame) {
  const auto points = [](std::uint64_t seed, std::uint64_t trial) {
    return variedScan(kScan, {.noiseMm = 1}, seed, trial).points;
  };
  EXPECT_EQ(points(3, 5), points(3, 5));
  EXPECT_NE(points(3, 5), points(3, 6));
  EXPECT_NE(points(3, 5), points(4, 5));
}

}  // namespace
}  // namespace falciform
