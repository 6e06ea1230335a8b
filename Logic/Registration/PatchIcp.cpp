#include "Logic/Registration/PatchIcp.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "Logic/Core/Median.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk =
    512;  // fixed, so that sums are formed in one order whatever the number of threads

/// Sums over matched pairs, enough for the closed-form fit of Eq. (III.2) and the residuals.
struct PairSums {
  double weight = 0, squared = 0, weightedSquared = 0;
  Vector3d source = Vector3d::Zero(), target = Vector3d::Zero();
  Matrix3d cross = Matrix3d::Zero();

  void add(const Vector3d& s, const Vector3d& t, double w, double squaredDistance) {
    weight += w;
    squared += squaredDistance;
    weightedSquared += w * squaredDistance;
    source += w * s;
    target += w * t;
    cross += w * s * t.transpose();
  }
  PairSums& operator+=(const PairSums& o) {
    weight += o.weight;
    squared += o.squared;
    weightedSquared += o.weightedSquared;
    source += o.source;
    target += o.target;
    cross += o.cross;
    return *this;
  }
  [[nodiscard]] Isometry3d fit() const {
    const Vector3d s = source / weight, t = target / weight;
    return rigidFromMoments(s, t, cross - weight * s * t.transpose());
  }
};

/// Rounding of many steps would let the linear part drift from a rotation: brings it back.
Isometry3d orthonormalised(Isometry3d pose) {
  pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
  return pose;
}

std::string stageText(const IterationRecord& r) {
  char text[96];
  std::snprintf(text, sizeof text, "iteration %d: RMS %.2f mm, patch weight %.0f", r.iteration, r.rmsMm,
                r.patchWeight);
  return text;
}

}  // namespace

double patchWeight(const RegistrationSettings& s, int iteration) {
  if (s.method == RegistrationMethod::Icp) return 1;
  if (s.method == RegistrationMethod::Wgf) return s.weightMax;
  const double decay = std::exp(-s.relaxation * (iteration - 1));
  return s.weightMax * decay + s.weightBase * (1 - decay);  // Eq. (III.3)
}

PatchIcpResult runPatchIcp(const LabelledTarget& target, const LabelledSource& source,
                           const RegistrationSettings& settings, const Isometry3d& preopFromScanStart,
                           int firstIteration, const Progress& progress, const IterationObserver& observer) {
  const auto n = static_cast<std::size_t>(source.points.rows());
  const Points corners = boxCorners(source.points);
  const double last =
      settings.method == RegistrationMethod::Picp ? settings.weightBase : patchWeight(settings, 1);

  PatchIcpResult result;
  result.preopFromScan = preopFromScanStart;
  std::vector<int> matches(n, -1);
  std::vector<double> squaredDistances(n);
  double scale = 0;  // Welsch scale of this iteration, mm; 0: all points count alike
  std::vector<PairSums> parts((n + kChunk - 1) / kChunk);
  double previousRms = -1;

  for (int step = 0; step < settings.maxIterations; ++step) {
    const int iteration = firstIteration + step;
    const double weight = patchWeight(settings, iteration);
    forEachChunk(n, kChunk, [&](std::size_t begin, std::size_t end) {
      PairSums sums;
      for (std::size_t i = begin; i < end; ++i) {
        const Vector3d moved = result.preopFromScan * source.points.row(static_cast<Index>(i)).transpose();
        const int label = source.labels[i];
        const Neighbour match =
            target.closest(moved, label, settings.correspondenceWeight, matches[i]);  // Eq. (III.1)
        matches[i] = match.index;
        squaredDistances[i] = match.squaredDistance;
        double w = label > 0 ? weight : 1.0;
        if (scale > 0) w *= std::exp(-match.squaredDistance / (2 * scale * scale));
        sums.add(moved, target.points().row(match.index).transpose(), w, match.squaredDistance);
      }
      parts[begin / kChunk] = sums;
    });
    PairSums sums;
    for (const PairSums& part : parts) sums += part;
    const Isometry3d move = sums.fit();  // Eq. (III.2)
    const Points before = transformed(corners, result.preopFromScan);
    result.preopFromScan = orthonormalised(move * result.preopFromScan);

    IterationRecord record;
    record.iteration = iteration;
    record.rmsMm = std::sqrt(sums.squared / static_cast<double>(n));
    record.patchWeight = weight;
    record.motionMm = (transformed(corners, result.preopFromScan) - before).rowwise().norm().maxCoeff();
    record.preopFromScan = result.preopFromScan;
    result.history.push_back(record);
    if (observer) observer(record);
    if (step % 8 == 0) progress.report(static_cast<double>(step) / settings.maxIterations, stageText(record));

    if (settings.stop == StopRule::Rms && previousRms >= 0 &&
        std::abs(previousRms - record.rmsMm) < settings.rmsToleranceMm) {
      result.converged = true;
      result.stopReason = "the RMS residual changed by less than the tolerance";
      break;
    }
    if (settings.stop == StopRule::Motion && record.motionMm < settings.motionToleranceMm &&
        weight <= 1.01 * last) {
      result.converged = true;
      result.stopReason = "nothing moved farther than the tolerance and the patch weight had relaxed";
      break;
    }
    previousRms = record.rmsMm;
    // Far from the answer every residual is large and none is an outlier: the scale follows the residuals
    // down.
    if (settings.robustScaleMm > 0)
      scale = std::max(settings.robustScaleMm, 3 * std::sqrt(medianInPlace(squaredDistances)));
  }
  if (!result.converged) result.stopReason = "the largest number of iterations was reached";
  return result;
}

}  // namespace falciform
