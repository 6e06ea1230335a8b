#include "Logic/Registration/PoseSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"

namespace falciform {

namespace {

// A grid of 72 has a covering radius of about 45 deg, well inside the reach of labelled points; a whole
// surface with no labels needs one of about 28 deg.
constexpr int kPatchRotations = 72, kSurfaceRotations = 300;
constexpr std::size_t kRefined = 12;  // at most so many poses are refined on the whole sample
constexpr Index kQuickPoints = 150;
// With two patches one point in so many does at first; with one, wrong labels among few points mislead.
constexpr std::size_t kFewer = 3;
constexpr int kFirstSteps = 10;  // then the worse two thirds are given up
constexpr std::size_t kPromising = 100;
constexpr double kSameBasinMm = 10;  // poses that place the sample's box this near each other are one
constexpr double kFacing = 0.3;      // cosine: what a scanner sees of a surface

ScanSample subsetOf(const ScanSample& sample, const std::vector<int>& rows) {
  ScanSample part{rowsOf(sample.points, rows), rowsOf(sample.normals, rows), {}, sample.outward};
  for (const int i : rows) part.labels.push_back(sample.labels[static_cast<std::size_t>(i)]);
  return part;
}

void sortByScore(std::vector<StartPose>& poses) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const StartPose& a, const StartPose& b) { return a.score < b.score; });
}

/// Replaces each pose by what `improve` makes of it, poses in parallel: each is independent, so threads do
/// not matter.
template <class Improve>
void improveAll(std::vector<StartPose>& poses, const Progress& progress, const Improve& improve) {
  progress.report(0);
  forEachChunk(poses.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.stopRequested(); ++i) improve(poses[i]);
  });
  progress.report(1);  // throws Cancelled if a stop was requested meanwhile
}

StartPose poseOf(const Matrix3d& rotation, const Vector3d& from, const Vector3d& to) {
  StartPose pose;
  pose.preopFromScan.linear() = rotation;
  pose.preopFromScan.translation() = to - rotation * from;
  return pose;
}

}  // namespace

std::vector<Matrix3d> rotationGrid(int count) {
  // The two irrational constants of super-Fibonacci spirals: sqrt(2) and the positive root of psi^4 = psi
  // + 4.
  const double phi = std::numbers::sqrt2, psi = 1.533751168755204288118041;
  std::vector<Matrix3d> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5, inner = std::sqrt(s / count), outer = std::sqrt(1 - s / count);
    const double alpha = 2 * std::numbers::pi * s / phi, beta = 2 * std::numbers::pi * s / psi;
    rotations.push_back(Eigen::Quaterniond(outer * std::cos(beta), inner * std::sin(alpha),
                                           inner * std::cos(alpha), outer * std::sin(beta))
                            .toRotationMatrix());
  }
  return rotations;
}

void keepDistinct(std::vector<StartPose>& poses, const Points& corners, std::size_t count) {
  sortByScore(poses);
  std::vector<StartPose> kept;
  std::vector<Points> places;
  for (const StartPose& pose : poses) {
    const Points moved = transformed(corners, pose.preopFromScan);
    const auto same = std::find_if(places.begin(), places.end(), [&](const Points& place) {
      return (place - moved).rowwise().norm().maxCoeff() < kSameBasinMm;
    });
    if (same != places.end()) {
      kept[static_cast<std::size_t>(same - places.begin())].starts += pose.starts;
    } else if (kept.size() < count) {
      kept.push_back(pose);
      places.push_back(moved);
    }
  }
  poses = std::move(kept);
}

std::vector<StartPose> startsFromPatches(const PreparedPreop& preop, const ScanSample& sample,
                                         const Progress& progress) {
  // The mean of the labels' centroids: each patch counts alike, however densely it is sampled.
  const auto on = centroidsByLabel(sample.points, sample.labels);
  Vector3d from = Vector3d::Zero(), to = Vector3d::Zero();
  for (const auto& [label, centroid] : on) {
    from += centroid / static_cast<double>(on.size());
    to += preop.labelCentroids().at(label) / static_cast<double>(on.size());
  }
  std::vector<StartPose> poses;
  for (const Matrix3d& rotation : rotationGrid(kPatchRotations)) poses.push_back(poseOf(rotation, from, to));

  // Few points decide which poses are worth many.
  const std::size_t fewer = on.size() > 1 ? kFewer : 1;
  std::vector<int> labelled, quickLabelled, quickAll;
  for (std::size_t i = 0; i < sample.labels.size(); ++i) {
    const int row = static_cast<int>(i);
    if (sample.labels[i] > 0) labelled.push_back(row);
    if (sample.labels[i] > 0 && labelled.size() % fewer == 0) quickLabelled.push_back(row);
    if (i % fewer == 0) quickAll.push_back(row);
  }
  const ScanSample patches = subsetOf(sample, labelled), quickPatches = subsetOf(sample, quickLabelled),
                   quick = subsetOf(sample, quickAll);
  const Points corners = boxCorners(sample.points);
  improveAll(poses, progress.part(0, 0.4), [&](StartPose& pose) {
    alignCoarsely(preop.coarse(), quickPatches.size() < 6 ? patches : quickPatches, {1, 1, false}, 15, pose);
    scoreCoarsely(preop.coarse(), patches, pose);
  });
  keepDistinct(poses, corners, kRefined);
  improveAll(poses, progress.part(0.4, fewer > 1 ? 0.7 : 1), [&](StartPose& pose) {
    alignCoarsely(preop.coarse(), quick, {30, 1, true}, fewer > 1 ? 15 : 25, pose);
    scoreCoarsely(preop.coarse(), sample, pose);
  });
  keepDistinct(poses, corners, kRefined);
  if (fewer == 1) return poses;
  improveAll(poses, progress.part(0.7, 1), [&](StartPose& pose) {
    alignCoarsely(preop.coarse(), sample, {1, 1, true}, 15, pose);
    scoreCoarsely(preop.coarse(), sample, pose);
  });
  keepDistinct(poses, corners, kRefined);
  return poses;
}

std::vector<StartPose> startsFromSurface(const PreparedPreop& preop, const ScanSample& sample,
                                         const Progress& progress) {
  const Points corners = boxCorners(sample.points);
  const Vector3d from = sample.points.colwise().mean(), facing = sample.normals.colwise().sum().normalized();
  std::vector<StartPose> poses;
  // Where it is not known which side of the scan is outward, both are tried.
  std::vector<ScanSample> sides{sample};
  if (!sample.outward) {
    sides.push_back(sample);
    sides.back().normals *= -1;
  }
  const std::vector<int> quickRows = randomRows(sample.size(), kQuickPoints);
  const std::vector<int> seen = randomRows(preop.surface().size(), 1000);
  const std::vector<Matrix3d> rotations = rotationGrid(kSurfaceRotations);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    std::vector<StartPose> found;
    for (const Matrix3d& rotation : rotations) {
      const Vector3d towards = rotation * facing * (side == 0 ? 1 : -1);
      Vector3d sum = Vector3d::Zero();
      double weights = 1e-9;
      for (const int i : seen) {
        const double weight = preop.normals().row(i).dot(towards) - kFacing;
        if (weight <= 0) continue;
        sum += weight * preop.surface().points.row(i).transpose();
        weights += weight;
      }
      found.push_back(poseOf(rotation, from, sum / weights));
    }
    const ScanSample quick = subsetOf(sides[side], quickRows);
    const double begin = static_cast<double>(side) / static_cast<double>(sides.size());
    improveAll(found, progress.part(begin, begin + 1.0 / static_cast<double>(sides.size())),
               [&](StartPose& pose) {
                 alignCoarsely(preop.coarse(), quick, {0, 0, true}, kFirstSteps, pose);
                 scoreCoarsely(preop.coarse(), quick, pose);
               });
    keepDistinct(found, corners, kPromising);
    improveAll(found, {}, [&](StartPose& pose) {
      alignCoarsely(preop.coarse(), quick, {0, 0, true}, kFirstSteps, pose);
      scoreCoarsely(preop.coarse(), quick, pose);
    });
    keepDistinct(found, corners, kRefined);
    improveAll(found, {}, [&](StartPose& pose) {
      alignCoarsely(preop.coarse(), sides[side], {0, 0, true}, 15, pose);
      scoreCoarsely(preop.coarse(), sides[side], pose);
    });
    poses.insert(poses.end(), found.begin(), found.end());
  }
  keepDistinct(poses, corners, kRefined);
  return poses;
}

}  // namespace falciform
