#include "Logic/Registration/RegistrationFigures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Patches/PatchStatistics.h"

namespace falciform {

namespace {

constexpr double kCoverageReachMm = 5;  // a pre-op vertex is covered if a scan point lies this near
constexpr double kFailedRmsMm = 5;  // the thesis calls a clinical registration above this failed (ch. III)
// Root mean square over the organ. A target error of 5 mm is a failure (ch. III); of livers that bent by as
// much as this says, more than one in four is farther off (Docs/Performance.md).
constexpr double kExpectedMm = 3;
constexpr double kPatchRmsMm = 8;  // its feature errors of good registrations stay below this (Table III.3)

/// A scan point's squared distances, mm^2: to the nearest pre-op point and to that of its own label (infinite
/// where it has none or the surface has not).
struct Residual {
  double squared = 0, own = std::numeric_limits<double>::infinity();
  int label = 0;  ///< of the nearest pre-op point
};

std::vector<Residual> residualsOf(const PreparedPreop& preop, const Surface& scan, const KdTree& scanTree,
                                  const Isometry3d& preopFromScan) {
  const LabelledTarget& target = preop.target();
  const std::vector<int> order = scanTree.inSpaceOrder();
  std::vector<Residual> residuals(order.size());
  forEachChunk(order.size(), 256, [&](std::size_t begin, std::size_t end) {
    int guess = -1;
    for (std::size_t k = begin; k < end; ++k) {
      const int i = order[k], label = scan.patchAt(i);
      const Vector3d place = preopFromScan * scan.points.row(i).transpose();
      if (guess < 0) guess = preop.coarse().rowNear(place.cast<float>());
      const Neighbour near = target.closest(place, 0, 1, guess);
      guess = near.index;  // the next point is not far
      Residual& r = residuals[static_cast<std::size_t>(i)];
      r.squared = near.squaredDistance;
      r.label = target.labelOf(near.index);
      if (label > 0 && target.has(label))
        r.own = r.label == label ? r.squared : target.closestOfLabel(place, label).squaredDistance;
    }
  });
  return residuals;
}

double coveredShare(const PreparedPreop& preop, const KdTree& scanTree, const Isometry3d& scanFromPreop) {
  const std::vector<int>& sample = preop.sample();
  std::vector<char> near(sample.size());
  forEachChunk(near.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      near[i] = scanTree
                    .nearest(scanFromPreop * preop.surface().points.row(sample[i]).transpose(),
                             kCoverageReachMm * kCoverageReachMm)
                    .index >= 0;
  });
  double covered = 0, all = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (near[i]) covered += preop.areas()[sample[i]];
    all += preop.areas()[sample[i]];
  }
  return covered / all;
}

std::string mm(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", value);
  return text;
}

}  // namespace

void fillFigures(RegistrationResult& result, const PreparedPreop& preop, const Surface& scan,
                 const KdTree& scanTree, const LabelledSource& source, const RegistrationSettings& settings,
                 const Isometry3d& scanFromPreopStart) {
  const std::vector<Residual> residuals = residualsOf(preop, scan, scanTree, result.scanFromPreop.inverse());
  const double lastWeight = result.history.empty() ? 1 : result.history.back().patchWeight;
  const double ratio = settings.correspondenceWeight * settings.correspondenceWeight;
  double squared = 0, weighted = 0, weights = 0;
  std::vector<double> distances;
  distances.reserve(residuals.size());
  std::map<int, std::pair<double, double>> patches;  // sum of squares and count by label
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const Residual& r = residuals[i];
    squared += r.squared;
    distances.push_back(std::sqrt(r.squared));
    const int label = source.labels[i];
    const double weight = label > 0 ? lastWeight : 1;
    // Eq. (III.1): a point of another label only where it is nearer by far.
    const bool other = label == 0 || (r.label != label && r.squared < ratio * r.own);
    weighted += weight * (other ? r.squared : r.own);
    weights += weight;
    if (std::isinf(r.own)) continue;
    // Feature errors of every label both sides have, whether the method used it or not, as the thesis's
    // tables show them.
    auto& [sum, count] = patches[scan.patchAt(static_cast<Index>(i))];
    sum += r.own;
    ++count;
  }
  const auto n = static_cast<double>(residuals.size());
  result.rmsMm = std::sqrt(squared / n);
  result.weightedRmsMm = std::sqrt(weighted / weights);
  result.meanMm = std::accumulate(distances.begin(), distances.end(), 0.0) / n;
  const auto p95 = distances.begin() + static_cast<std::ptrdiff_t>(0.95 * (n - 1));
  std::nth_element(distances.begin(), p95, distances.end());
  result.p95Mm = *p95;
  for (const auto& [label, sums] : patches) result.patchRmsMm[label] = std::sqrt(sums.first / sums.second);
  result.coverage = coveredShare(preop, scanTree, result.scanFromPreop);
  const Isometry3d change = result.scanFromPreop * scanFromPreopStart.inverse();
  result.rotationDeg = Eigen::AngleAxisd(change.linear()).angle() * 180 / EIGEN_PI;
  const Vector3d middle = scan.points.colwise().mean();
  result.translationMm = (change * middle - middle).norm();
  result.scanPoints = scan.size();
  result.preopPoints = preop.surface().size();
}

std::vector<std::string> registrationWarnings(const RegistrationResult& result, const Surface& preop,
                                              const Surface& scan, const RegistrationSettings& settings) {
  std::vector<std::string> warnings;
  if (looksAtPatches(settings))
    warnings = patchWarnings(preop, scan);
  else if (settings.method != RegistrationMethod::Auto)
    warnings.push_back(
        "no patches were used: closest points alone find the pose only if the start is near it");
  if (result.warp)
    warnings.push_back(
        "the method is not rigid: the transform and the residuals are of its rigid part only, the moved "
        "surface and the target errors of the whole warp");
  if (!result.converged) warnings.push_back("the registration did not settle: " + result.stopReason);
  if (result.rmsMm > kFailedRmsMm)
    warnings.push_back("RMS residual is " + mm(result.rmsMm) + " (above " + mm(kFailedRmsMm) +
                       "): strong deformation, outliers or a wrong pose; look before you trust it");
  if (result.expectedErrorMeanMm > kExpectedMm)
    warnings.push_back("expected target error is " + mm(result.expectedErrorMeanMm) +
                       ": the liver has bent, or too little is seen, for a rigid pose to be trusted nearer");
  for (const auto& [label, rms] : result.patchRmsMm)
    if (rms > kPatchRmsMm)
      warnings.push_back("patch " + patchName(preop, label) + " fits with " + mm(rms) +
                         " RMS: mislabelled, or the pose is wrong");
  if (result.coverage < 0.15)
    warnings.push_back("the scan covers only " +
                       std::to_string(static_cast<int>(std::lround(100 * result.coverage))) +
                       " % of the surface: the pose rests on little");
  if (result.basins.size() > 1 && result.basins[1].score < 1.3 * result.basins[0].score)
    warnings.push_back("another pose fits almost as well: look at the list of basins");
  return warnings;
}

}  // namespace falciform
