#include "Logic/Atlas/ClosestAtlas.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "Logic/Atlas/AtlasCoefficients.h"
#include "Logic/Atlas/MethodResult.h"
#include "Logic/Atlas/ScanChoice.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"
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
      : model_(model),
        plan_(plan),
        settings_(settings),
        pose_(scanFromPreopStart.inverse()),
        scan_(chooseScanPoints(scan, settings.samplePoints, seed)),
        search_(model.fine(), plan.patches, plan.correspondenceWeight) {
    if (plan.solve == AtlasSolve::Statistical) statistics_.emplace(model.atlas(), plan.varianceShare);
    found_.modes = VectorXd::Zero(model.atlas().rank());
  }

  UpdateResult run(const Progress& progress) {
    UpdateResult result;
    match();                     // Step 1
    double previous = solve(1);  // Step 2
    for (int i = 1; i <= plan_.maxIterations; ++i) {
      if (i % 8 == 1) progress.report(static_cast<double>(i) / plan_.maxIterations, "Fitting the atlas");
      match();
      pose_ = fitRigid(posed_, placesOf(matches_, search_.points()), weights(i)) * pose_;  // Step 3
      match();                                                                             // Step 4
      const double rms = solve(i);                                                         // Steps 5 and 6
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
  void match() {
    posed_ = transformed(scan_.points, pose_);
    matches_ = search_.find(posed_, scan_.labels);
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
      if (search_.uses(scan_.labels[static_cast<std::size_t>(j)])) all[j] = onPatch;
    return all;
  }

  /// New coefficients for these correspondences. Returns the RMS distance to the counterparts after them.
  double solve(int iteration) {
    const Index rank = model_.atlas().rank();
    const VectorXd w = weights(iteration);
    const Points rest = placesOf(matches_, model_.fine().points);
    const std::size_t chunks = (matches_.size() + kChunk - 1) / kChunk;
    std::vector<Eigen::MatrixXd> parts(chunks);
    forEachChunk(matches_.size(), kChunk, [&](std::size_t first, std::size_t last) {
      Eigen::MatrixXd rows(rank + 1, static_cast<Index>(3 * (last - first)));
      for (std::size_t j = first; j < last; ++j) {
        const auto row = static_cast<Index>(j);
        auto own = rows.middleCols<3>(static_cast<Index>(3 * (j - first)));
        own.topRows(rank) = model_.modesAt(matches_[j]).transpose();
        own.bottomRows<1>() = posed_.row(row) - rest.row(row);
        own *= std::sqrt(w[row]);
      }
      parts[first / kChunk] = outerSquare(rows);
    });
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rank + 1, rank + 1);
    for (const Eigen::MatrixXd& part : parts) sum += part;
    const double residual = (placesOf(matches_, search_.points()) - posed_).squaredNorm();
    const double spread = (posed_.rowwise() - posed_.colwise().mean()).squaredNorm();
    const auto points = static_cast<double>(posed_.rows());
    ModalEquations equations{.square = sum.topLeftCorner(rank, rank), .right = sum.col(rank).head(rank)};
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
    search_.moveTo(model_.movedPoints(found_.modes));
    return std::sqrt((placesOf(matches_, search_.points()) - posed_).squaredNorm() / points);
  }

  const AtlasModel& model_;
  const ClosestAtlasPlan& plan_;
  const UpdateSettings& settings_;
  Isometry3d pose_;  ///< pre-op from scan
  ScanChoice scan_;
  CounterpartSearch search_;  ///< in the surface as it is now
  std::optional<MemberStatistics> statistics_;
  AtlasCoefficients found_;
  Points posed_;
  std::vector<Counterpart> matches_;
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
  return timedUpdate(settings, [&] {
    return ClosestAtlasFit(model, scan, scanFromPreopStart, plan, settings, seed).run(progress);
  });
}

}  // namespace falciform
