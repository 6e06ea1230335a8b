#include "Logic/Registration/ClosestPointLoop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {

ClosestOnPreop::ClosestOnPreop(const PreparedPreop& preop) : points_(preop.target()) {
  if (preop.surface().triangles.rows() > 0) triangles_.emplace(preop.surface());
}

std::optional<Vector3d> ClosestOnPreop::closest(const Vector3d& query, double boundMm) const {
  if (triangles_) {
    const ClosestPlace place = triangles_->closest(query, boundMm);
    return place.triangle < 0 ? std::nullopt : std::optional(place.point);
  }
  const Neighbour match = points_.closest(query, patch::kNone, 1);
  if (match.squaredDistance >= boundMm * boundMm) return std::nullopt;
  return points_.points().row(match.index).transpose();
}

void ClosestOnPreop::closest(const Points& queries, Points& places) const {
  places.resize(queries.rows(), 3);
  forEachChunk(static_cast<std::size_t>(queries.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      const Vector3d query = queries.row(i).transpose();
      places.row(i) = closest(query).value_or(query).transpose();
    }
  });
}

VectorXd robustWeights(const VectorXd& distances, const RegistrationSettings& settings) {
  if (settings.robustScaleMm <= 0) return VectorXd::Ones(distances.size());
  std::vector<double> sorted(distances.begin(), distances.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double scale = std::max(settings.robustScaleMm, 3 * *middle);
  return (-(distances / scale).array().square() / 2).exp();
}

double largestMotion(const Points& points, const Isometry3d& a, const Isometry3d& b) {
  // The point that moves farthest under a rigid step moves no farther than a corner of the points' box.
  const Eigen::Matrix<double, 2, 3> box = boundingBox(points);
  Points corners(8, 3);
  for (int c = 0; c < 8; ++c)
    for (int axis = 0; axis < 3; ++axis) corners(c, axis) = box(c >> axis & 1, axis);
  return (transformed(corners, a) - transformed(corners, b)).rowwise().norm().maxCoeff();
}

void noteIteration(PatchIcpResult& result, const IterationRecord& record, double fraction,
                   const Progress& progress, const IterationObserver& observer) {
  result.history.push_back(record);
  if (observer) observer(record);
  char stage[64];
  std::snprintf(stage, sizeof stage, "iteration %d: RMS %.2f mm", record.iteration, record.rmsMm);
  progress.report(std::min(1.0, fraction), stage);
}

PatchIcpResult runClosestPointLoop(const Points& scan, const MatchPoints& match,
                                   const RegistrationSettings& settings, const Isometry3d& start,
                                   const Progress& progress, const IterationObserver& observer) {
  PatchIcpResult result;
  result.preopFromScan = start;
  result.stopReason = "the largest number of iterations was reached";
  Points matched;
  double previousRms = -1;
  for (int k = 1; k <= settings.maxIterations && !result.converged; ++k) {
    match(transformed(scan, result.preopFromScan), matched);
    const Isometry3d before = result.preopFromScan;
    const VectorXd distances = (transformed(scan, before) - matched).rowwise().norm();
    result.preopFromScan = fitRigid(scan, matched, robustWeights(distances, settings));
    IterationRecord record;
    record.iteration = k;
    record.rmsMm = std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()));
    record.motionMm = largestMotion(scan, before, result.preopFromScan);
    record.preopFromScan = result.preopFromScan;
    noteIteration(result, record, static_cast<double>(k) / settings.maxIterations, progress, observer);
    const bool settled = settings.stop == StopRule::Rms && previousRms >= 0 &&
                         std::abs(previousRms - record.rmsMm) < settings.rmsToleranceMm;
    const bool still = settings.stop == StopRule::Motion && record.motionMm < settings.motionToleranceMm;
    result.converged = settled || still;
    if (settled) result.stopReason = "the RMS residual changed by less than the tolerance";
    if (still) result.stopReason = "nothing moved farther than the tolerance";
    previousRms = record.rmsMm;
  }
  return result;
}

}  // namespace falciform
