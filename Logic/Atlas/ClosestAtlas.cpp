#include "Logic/Atlas/ClosestAtlas.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "Logic/Atlas/AtlasCoefficients.h"
#include "Logic/Atlas/MethodResult.h"
#include "Logic/Atlas/ScanChoice.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/LabelledTarget.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 256;

/// One scan and one atlas, iteration by iteration.
class ClosestAtlasFit {
 public:
  ClosestAtlasFit(const AtlasModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
                  const ClosestAtlasPlan& plan, const UpdateSettings& settings, std::uint64_t seed)
      : model_(model), plan_(plan), settings_(settings), pose_(scanFromPreopStart.inverse()) {
    scan_ = chooseScanPoints(scan, settings.samplePoints, seed);
    if (plan.patches) labels_ = patchLabels(model.fine());
    if (plan.solve == AtlasSolve::Statistical) statistics_.emplace(model.atlas(), plan.varianceShare);
    found_.modes = VectorXd::Zero(model.atlas().rank());
    moved_ = model.fine().points;
  }

  UpdateResult run(const Progress& progress) {
    UpdateResult result;
    seek();
    match();                     // Step 1
    double previous = solve(1);  // Step 2
    for (int i = 1; i <= plan_.maxIterations; ++i) {
      if (i % 8 == 1) progress.report(static_cast<double>(i) / plan_.maxIterations, "Fitting the atlas");
      seek();
      match();
      pose_ = fitRigid(posed_, counterparts_, weights(i)) * pose_;  // Step 3
      match();                                                      // Step 4
      const double rms = solve(i);                                  // Steps 5 and 6
      result.iterations = i;
      result.rmsMm = rms;
      if (std::abs(rms - previous) < plan_.rmsToleranceMm) {
        result.converged = true;
        break;
      }
      previous = rms;
    }
    result.stopReason = result.converged ? "the RMS residual changed by less than the tolerance"
                                         : "the largest number of iterations was reached";
    result.scanFromPreop = pose_.inverse();
    result.displacements = model_.displacements(found_.modes);
    result.coefficients = found_.members.size() > 0 ? found_.members : found_.modes;
    describeDeformation(model_.atlas().mesh, result);
    return result;
  }

 private:
  /// What closest points are sought in: the surface as it is now.
  void seek() {
    Surface now;
    now.points = moved_;
    now.patch = model_.fine().patch;
    target_.emplace(now, labels_);
  }

  void match() {
    posed_ = transformed(scan_.points, pose_);
    counterparts_.resize(posed_.rows(), 3);
    matches_.resize(scan_.labels.size(), -1);
    forEachChunk(matches_.size(), kChunk, [&](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) {
        const auto row = static_cast<Index>(j);
        const int label = plan_.patches && target_->has(scan_.labels[j]) ? scan_.labels[j] : 0;
        matches_[j] =
            target_->closest(posed_.row(row).transpose(), label, plan_.correspondenceWeight, matches_[j])
                .index;  // Eq. (III.1)
        counterparts_.row(row) = moved_.row(matches_[j]);
      }
    });
  }

  /// The diagonal of W_f: w_PBR on patches, 1 elsewhere.
  [[nodiscard]] VectorXd weights(int iteration) const {
    RegistrationSettings schedule;
    schedule.weightMax = plan_.weightMax;
    schedule.weightBase = plan_.weightBase;
    schedule.relaxation = plan_.relaxation;
    const double onPatch = plan_.patches ? patchWeight(schedule, iteration) : 1;
    VectorXd all = VectorXd::Ones(posed_.rows());
    for (Index j = 0; j < all.size(); ++j)
      if (target_->has(scan_.labels[static_cast<std::size_t>(j)])) all[j] = onPatch;
    return all;
  }

  /// New coefficients for these correspondences. Returns the RMS distance to the counterparts after them.
  double solve(int iteration) {
    const Index rank = model_.atlas().rank();
    const VectorXd w = weights(iteration);
    const std::size_t chunks = (matches_.size() + kChunk - 1) / kChunk;
    std::vector<Eigen::MatrixXd> parts(chunks, Eigen::MatrixXd::Zero(rank, rank + 1));
    forEachChunk(matches_.size(), kChunk, [&](std::size_t first, std::size_t last) {
      Eigen::MatrixXd& part = parts[first / kChunk];
      for (std::size_t j = first; j < last; ++j) {
        const auto row = static_cast<Index>(j);
        const Eigen::Matrix<double, 3, Eigen::Dynamic> modes = model_.modesAt(matches_[j]).cast<double>();
        const Vector3d from = model_.fine().points.row(matches_[j]).transpose();
        part.leftCols(rank) += w[row] * modes.transpose() * modes;
        part.col(rank) += w[row] * modes.transpose() * (posed_.row(row).transpose() - from);
      }
    });
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rank, rank + 1);
    for (const Eigen::MatrixXd& part : parts) sum += part;
    const double residual = (counterparts_ - posed_).squaredNorm();
    const double spread = (posed_.rowwise() - posed_.colwise().mean()).squaredNorm();
    const auto points = static_cast<double>(posed_.rows());
    ModalEquations equations{.square = sum.leftCols(rank), .right = sum.col(rank)};
    equations.relativeError = std::sqrt(residual / spread);  // Eq. (V.18)
    equations.pointVariance =
        std::max(residual / (3 * points), settings_.noiseFloorMm * settings_.noiseFloorMm);
    equations.pointsPerSample = std::max(1.0, points / settings_.effectiveSamples);
    switch (plan_.solve) {
      case AtlasSolve::Tikhonov:
        found_ = tikhonovCoefficients(model_.atlas(), equations, plan_.lambda);
        break;
      case AtlasSolve::Constrained:
        found_ = constrainedCoefficients(model_.atlas(), equations);
        break;
      case AtlasSolve::Statistical:
        found_ = statistics_->mostProbable(equations);
        break;
    }
    moved_ = model_.movedPoints(found_.modes);
    return std::sqrt((moved_(matches_, Eigen::all) - posed_).squaredNorm() / points);
  }

  const AtlasModel& model_;
  const ClosestAtlasPlan& plan_;
  const UpdateSettings& settings_;
  Isometry3d pose_;  ///< pre-op from scan
  ScanChoice scan_;
  std::vector<int> labels_;
  std::optional<MemberStatistics> statistics_;
  AtlasCoefficients found_;
  Points moved_;                          ///< the fine surface's points as they are now
  std::optional<LabelledTarget> target_;  ///< over them
  Points posed_, counterparts_;
  std::vector<int> matches_;
};

}  // namespace

ClosestAtlasPlan icatPlan() { return {}; }

ClosestAtlasPlan icatStarPlan() { return {.patches = true, .weightMax = 2000, .weightBase = 1}; }

ClosestAtlasPlan constrainedPlan() { return {.solve = AtlasSolve::Constrained, .patches = true}; }

ClosestAtlasPlan pcaPlan() { return {.solve = AtlasSolve::Statistical, .patches = true}; }

UpdateResult updateByClosestAtlas(const AtlasModel& model, const Surface& scan,
                                  const Isometry3d& scanFromPreopStart, const ClosestAtlasPlan& plan,
                                  const UpdateSettings& settings, std::uint64_t seed,
                                  const Progress& progress) {
  checkSettings(settings);
  const Stopwatch watch;
  keepBlasSingleThreaded();
  UpdateResult result = ClosestAtlasFit(model, scan, scanFromPreopStart, plan, settings, seed).run(progress);
  result.seconds = watch.seconds();
  return result;
}

}  // namespace falciform
