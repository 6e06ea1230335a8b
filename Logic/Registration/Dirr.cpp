#include "Logic/Registration/Dirr.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/ClosestPointLoop.h"
#include "Logic/Registration/PowellMinimiser.h"

namespace falciform {

namespace {

constexpr Index kSample = 1000;
constexpr double kFinestMm = 0.01;  // below, the sample moves the answer more than the search does
constexpr std::array kScalesMm{8.0, 4.0, 2.0};
constexpr double kReach = 4;  // scales; a point beyond counts as deformed and nothing else: exp(-8) < 4e-4
constexpr std::size_t kChunk = 128;

/// A pose as six parameters of one scale, mm: the arc that a point at the scan's radius runs through about
/// each axis, and the shift of the scan's centroid.
struct PoseAround {
  Isometry3d start;
  Vector3d centre;  // of the scan at the start, pre-op mm
  double radius;

  [[nodiscard]] Isometry3d operator()(const VectorXd& p) const {
    const Vector3d turn = p.head<3>() / radius;
    const double angle = turn.norm();
    const Vector3d axis = angle > 0 ? Vector3d(turn / angle) : Vector3d(Vector3d::UnitX());
    const Eigen::AngleAxisd rotation(angle, axis);
    return Eigen::Translation3d(centre + p.tail<3>()) * rotation * Eigen::Translation3d(-centre) * start;
  }
};

/// Shares of a sample: how much of it fits, and the RMS of what lies within reach.
class Fit {
 public:
  Fit(const PreparedPreop& preop, Points sample) : surface_(preop), sample_(std::move(sample)) {}

  /// 1 - mean exp(-d^2 / 2 s^2), in [0, 1].
  [[nodiscard]] double misfit(const Isometry3d& pose, double scaleMm) const {
    const auto n = static_cast<std::size_t>(sample_.rows());
    std::vector<double> parts((n + kChunk - 1) / kChunk);
    forEachChunk(n, kChunk, [&](std::size_t begin, std::size_t end) {
      double fitting = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const Vector3d moved = pose * sample_.row(static_cast<Index>(i)).transpose();
        if (const auto place = surface_.closest(moved, kReach * scaleMm))
          fitting += std::exp(-(*place - moved).squaredNorm() / (2 * scaleMm * scaleMm));
      }
      parts[begin / kChunk] = fitting;
    });
    double fitting = 0;
    for (const double part : parts) fitting += part;
    return 1 - fitting / static_cast<double>(n);
  }

  [[nodiscard]] double rms(const Isometry3d& pose) const {
    const Points moved = transformed(sample_, pose);
    Points places;
    surface_.closest(moved, places);
    return std::sqrt((moved - places).squaredNorm() / static_cast<double>(moved.rows()));
  }

 private:
  ClosestOnPreop surface_;
  Points sample_;
};

}  // namespace

PatchIcpResult registerDirr(const PreparedPreop& preop, const Surface& scan,
                            const RegistrationSettings& settings, const Isometry3d& start,
                            const Progress& progress, const IterationObserver& observer) {
  const Points sample = rowsOf(scan.points, spreadSample(scan.points, kSample));
  const Vector3d middle = centroid(sample);
  const double radius = std::sqrt((sample.rowwise() - middle.transpose()).rowwise().squaredNorm().mean());
  const Fit fit(preop, sample);

  PatchIcpResult result;
  result.preopFromScan = start;
  double rms = fit.rms(start);
  for (std::size_t stage = 0; stage < kScalesMm.size(); ++stage) {
    const double scale = stage == 0 ? std::max(kScalesMm[0], rms) : kScalesMm[stage];
    const PoseAround pose{result.preopFromScan, result.preopFromScan * middle, std::max(radius, 1.0)};
    const double from = static_cast<double>(stage) / kScalesMm.size();
    const auto misfit = [&](const VectorXd& p) {
      if (progress.stopRequested()) progress.report(from);  // throws
      return fit.misfit(pose(p), scale);
    };
    const auto afterSweep = [&](const VectorXd& p, double) {
      IterationRecord record;
      record.iteration = static_cast<int>(result.history.size()) + 1;
      record.rmsMm = rms;
      record.preopFromScan = pose(p);
      record.motionMm = largestMotion(scan.points, result.preopFromScan, record.preopFromScan);
      result.preopFromScan = record.preopFromScan;
      rms = fit.rms(record.preopFromScan);
      noteIteration(result, record, from, progress, observer);
    };
    PowellLimits limits;
    limits.tolerance =
        stage + 1 < kScalesMm.size() ? scale / 50 : std::max(settings.motionToleranceMm, kFinestMm);
    limits.maxSweeps = settings.maxIterations - static_cast<int>(result.history.size());
    const PowellResult found = minimisePowell(misfit, VectorXd::Zero(6), scale / 2, limits, afterSweep);
    result.converged = found.converged;
  }
  result.stopReason = result.converged ? "a sweep of Powell's method moved nothing farther than the tolerance"
                                       : "the largest number of iterations was reached";
  return result;
}

}  // namespace falciform
