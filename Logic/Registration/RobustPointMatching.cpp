#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/ClosestPointLoop.h"
#include "Logic/Registration/NonRigidRegistration.h"

namespace falciform {

namespace {

constexpr Index kPreopSample = 1500, kMostScanSample = 500;
constexpr double kCooling = 0.9;  // of the temperature per stage; published: 0.93
constexpr int kIterationsPerStage = 2, kBalancings = 3;
// Share that goes to "no match", of what a point amid its counterparts gathers. Nearly every scan point has a
// counterpart; most pre-op points have none, and bound to have one they would pull the scan apart.
constexpr double kLooseScan = 0.15, kLoosePreop = 3;
constexpr double kStiffest = 10, kSoftest = 1e-2;  // of ThinPlateFit
constexpr double kReach = 4;                       // standard deviations; nothing matches from farther

/// Mean distance to the nearest other point.
double spacing(const Points& points) {
  const KdTree tree(points);
  double sum = 0;
  for (Index i = 0; i < points.rows(); ++i)
    sum += std::sqrt(tree.nearest(points.row(i).transpose(), 2).back().squaredDistance);
  return sum / static_cast<double>(points.rows());
}

/// A sample of `points` about as dense as `spacingMm` says: the number goes with 1 / spacing^2.
std::vector<int> sampleOfSpacing(const Points& points, double spacingMm) {
  const std::vector<int> trial = spreadSample(points, 300);
  const double ratio = spacing(rowsOf(points, trial)) / spacingMm;
  const double count = static_cast<double>(trial.size()) * ratio * ratio;
  return spreadSample(points, std::clamp<Index>(std::lround(count), 30, kMostScanSample));
}

using Weights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows of `points` within `reachMm` of a row of `others`.
Points nearTo(const Points& points, const Points& others, double reachMm) {
  const KdTree tree(others);
  std::vector<int> ids;
  for (Index i = 0; i < points.rows(); ++i)
    if (tree.nearest(points.row(i).transpose(), reachMm * reachMm).index >= 0)
      ids.push_back(static_cast<int>(i));
  return rowsOf(points, ids);
}

/// Softassign: how much scan point i and pre-op point j are one, at `temperature`, mm^2; columns and rows are
/// balanced in turn (Sinkhorn). `gathered`: what a point amid its counterparts gathers.
Weights softAssign(const Points& moved, const Points& fixed, double temperature, double gathered) {
  const Eigen::Array<double, 3, Eigen::Dynamic, Eigen::RowMajor> columnsOf = fixed.transpose().array();
  Weights m(moved.rows(), fixed.rows());
  forEachChunk(static_cast<std::size_t>(m.rows()), 16, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      m.row(i) = (((columnsOf.row(0) - moved(i, 0)).square() + (columnsOf.row(1) - moved(i, 1)).square() +
                   (columnsOf.row(2) - moved(i, 2)).square()) /
                  (-2 * temperature))
                     .exp();
  });
  VectorXd looseRows = VectorXd::Constant(m.rows(), kLooseScan * gathered);
  Eigen::RowVectorXd looseColumns = Eigen::RowVectorXd::Constant(m.cols(), kLoosePreop * gathered);
  for (int k = 0; k < kBalancings; ++k) {
    const Eigen::RowVectorXd columns = (m.colwise().sum() + looseColumns).cwiseInverse();
    m.array().rowwise() *= columns.array();
    looseColumns.array() *= columns.array();
    const VectorXd rows = (m.rowwise().sum() + looseRows).cwiseInverse();
    m.array().colwise() *= rows.array();
    looseRows.array() *= rows.array();
  }
  return m;
}

}  // namespace

NonRigidResult registerRobustPoints(const PreparedPreop& preop, const Surface& scan,
                                    const RegistrationSettings& settings, const Isometry3d& start,
                                    const Progress& progress, const IterationObserver& observer) {
  const Points& all = preop.surface().points;
  const Points fixed = rowsOf(all, spreadSample(all, kPreopSample));
  const double gap = spacing(fixed);
  const Points sample = rowsOf(scan.points, sampleOfSpacing(scan.points, gap));
  const ThinPlateFit fitter(sample, knotsFor(sample));
  Points moved = transformed(sample, start), virtualPoints(sample.rows(), 3);

  Points closest;
  ClosestOnPreop(preop).closest(moved, closest);
  const double far = std::sqrt((moved - closest).rowwise().squaredNorm().mean());
  const double hottest = std::pow(std::max(1.5 * far, 0.7 * gap), 2), coldest = std::pow(gap / 4, 2);
  PatchIcpResult run;
  run.preopFromScan = start;
  run.stopReason = "the largest number of iterations was reached";
  VectorXd weights;
  double stiffness = kStiffest;
  const auto tired = [&] { return static_cast<int>(run.history.size()) >= settings.maxIterations; };
  for (double heat = hottest; heat >= coldest && !tired(); heat *= kCooling) {
    const double cooled = std::log(heat / hottest) / std::log(coldest / hottest);  // 0 at first, 1 at last
    stiffness = kStiffest * std::pow(kSoftest / kStiffest, cooled);
    const double gathered = std::max(1.0, 2 * std::numbers::pi * heat / (gap * gap));
    const Points near = nearTo(fixed, moved, kReach * std::sqrt(heat));
    for (int k = 0; k < kIterationsPerStage && !tired(); ++k) {
      const Weights m = softAssign(moved, near, heat, gathered);
      weights = m.rowwise().sum().cwiseMax(1e-9);
      virtualPoints = weights.cwiseInverse().asDiagonal() * (m * near);
      const double squared = weights.dot((moved - virtualPoints).rowwise().squaredNorm()) / weights.sum();
      const ThinPlateSpline warp = fitter.fit(virtualPoints, weights, stiffness);
      const Points next = warp(sample);
      IterationRecord record;
      record.iteration = static_cast<int>(run.history.size()) + 1;
      record.rmsMm = std::sqrt(squared);
      record.motionMm = (next - moved).rowwise().norm().maxCoeff();
      record.preopFromScan = run.preopFromScan = warp.rigid();
      moved = next;
      noteIteration(run, record, cooled, progress, observer);
    }
    run.converged = heat * kCooling < coldest && !tired();
  }
  if (run.converged) run.stopReason = "the matching had cooled to the spacing of its points";
  return nonRigidFromPairs(preop, virtualPoints, sample, weights, stiffness, std::move(run));
}

}  // namespace falciform
