#include "Logic/Registration/PatchStarts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"

namespace falciform {

namespace {

// A grid of 72 has a covering radius of about 45 deg, well inside the reach of patch ICP
// (Docs/Registration.md measures it).
constexpr int kRotations = 72;
constexpr Index kPatchSample = 150, kSurfaceSample = 1000;
constexpr std::size_t kRefined = 16;  // at most so many poses are refined on the surface
constexpr double kSameBasinMm = 10;   // poses that place every sample point this near each other are one
constexpr double kScoreScaleMm = 5;

std::map<int, std::vector<int>> idsByLabel(const std::vector<int>& labels) {
  std::map<int, std::vector<int>> ids;
  for (std::size_t i = 0; i < labels.size(); ++i) ids[labels[i]].push_back(static_cast<int>(i));
  return ids;
}

/// Mean of the labels' centroids: each patch counts alike, however densely it is sampled.
Vector3d meanOfCentroids(const Points& points, const std::map<int, std::vector<int>>& ids) {
  Vector3d sum = Vector3d::Zero();
  int patches = 0;
  for (const auto& [label, rows] : ids) {
    if (label == 0) continue;
    sum += rowsOf(points, rows).colwise().mean().transpose();
    ++patches;
  }
  return sum / patches;
}

/// Merges poses that lie in one basin; `poses` sorted best first stay so.
std::vector<StartPose> distinct(const std::vector<StartPose>& poses, const Points& sample) {
  std::vector<StartPose> kept;
  std::vector<Points> places;
  for (const StartPose& pose : poses) {
    const Points moved = transformed(sample, pose.preopFromScan);
    const auto same = std::find_if(places.begin(), places.end(), [&](const Points& place) {
      return (place - moved).rowwise().norm().maxCoeff() < kSameBasinMm;
    });
    if (same != places.end()) {
      kept[static_cast<std::size_t>(same - places.begin())].starts += pose.starts;
      continue;
    }
    kept.push_back(pose);
    places.push_back(moved);
  }
  return kept;
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

std::vector<int> balancedSample(const LabelledSource& source, Index perLabel, Index others) {
  std::vector<int> sample;
  for (const auto& [label, ids] : idsByLabel(source.labels))
    for (const int i : spreadSample(rowsOf(source.points, ids), label > 0 ? perLabel : others))
      sample.push_back(ids[static_cast<std::size_t>(i)]);
  std::sort(sample.begin(), sample.end());
  return sample;
}

double robustScore(const LabelledTarget& target, const LabelledSource& source, double correspondenceWeight,
                   const Isometry3d& preopFromScan) {
  double sum = 0, weights = 0;
  for (Index i = 0; i < source.points.rows(); ++i) {
    const int label = source.labels[static_cast<std::size_t>(i)];
    const Vector3d moved = preopFromScan * source.points.row(i).transpose();
    const double squared = target.closest(moved, label, correspondenceWeight).squaredDistance;
    const double weight = label > 0 ? 3 : 1;
    sum += weight * squared / (squared + kScoreScaleMm * kScoreScaleMm);
    weights += weight;
  }
  return sum / weights;
}

std::vector<StartPose> startsFromPatches(const LabelledTarget& target, const LabelledSource& source,
                                         const RegistrationSettings& settings, const Progress& progress) {
  const LabelledSource sample = subsetOf(source, balancedSample(source, kPatchSample, kSurfaceSample));
  const auto sampleIds = idsByLabel(sample.labels);
  std::vector<int> patchRows;
  for (const auto& [label, ids] : sampleIds)
    if (label > 0) patchRows.insert(patchRows.end(), ids.begin(), ids.end());
  const LabelledSource patches = subsetOf(sample, patchRows);

  std::vector<int> targetLabels(static_cast<std::size_t>(target.points().rows()));
  for (std::size_t i = 0; i < targetLabels.size(); ++i) targetLabels[i] = target.labelOf(static_cast<int>(i));
  auto targetIds = idsByLabel(targetLabels);
  std::erase_if(targetIds, [&](const auto& entry) { return !sampleIds.contains(entry.first); });
  const Vector3d from = meanOfCentroids(sample.points, sampleIds),
                 to = meanOfCentroids(target.points(), targetIds);

  std::vector<StartPose> poses;
  for (const Matrix3d& rotation : rotationGrid(kRotations)) {
    StartPose pose;
    pose.preopFromScan.linear() = rotation;
    pose.preopFromScan.translation() = to - rotation * from;
    poses.push_back(pose);
  }

  // Patches alone, all weights equal: a few hundred points, so that every rotation can be tried.
  RegistrationSettings patchesOnly = settings;
  patchesOnly.method = RegistrationMethod::Picp;
  patchesOnly.stop = StopRule::Motion;
  patchesOnly.weightMax = patchesOnly.weightBase = 1;
  patchesOnly.robustScaleMm = 0;
  patchesOnly.maxIterations = 30;
  patchesOnly.motionToleranceMm = 0.5;
  improveAll(poses, progress.part(0, 0.5), [&](StartPose& pose) {
    const PatchIcpResult run = runPatchIcp(target, patches, patchesOnly, pose.preopFromScan);
    pose.preopFromScan = run.preopFromScan;
    pose.score = run.history.back().rmsMm;
  });
  sortByScore(poses);
  poses = distinct(poses, sample.points);
  poses.resize(std::min(poses.size(), kRefined));

  // Then with the surface, the patches' pull relaxing quickly.
  RegistrationSettings coarse = patchesOnly;
  coarse.weightMax = 100;
  coarse.relaxation = 0.15;
  coarse.robustScaleMm = settings.robustScaleMm;
  coarse.maxIterations = 60;
  coarse.motionToleranceMm = 0.1;
  improveAll(poses, progress.part(0.5, 1), [&](StartPose& pose) {
    pose.preopFromScan = runPatchIcp(target, sample, coarse, pose.preopFromScan).preopFromScan;
    pose.score = robustScore(target, sample, settings.correspondenceWeight, pose.preopFromScan);
  });
  sortByScore(poses);
  return distinct(poses, sample.points);
}

}  // namespace falciform
