#include "Logic/Atlas/ModelFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "Logic/Atlas/MethodResult.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Median.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 256;
constexpr int kCoarsePoints = 800;
constexpr double kCellMm = 30;       ///< wider than the scan's own errors are likely to go together
constexpr double kStaleMm = 0.15;    ///< RMS motion after which trees are made anew; vertices are 2 mm apart
constexpr double kSettledMm = 0.05;  ///< RMS change of the fitted surface under the scan by one step

constexpr int kRoughIterations = 6;                  ///< before which nothing but pose and bending is learnt
constexpr double kFirstReachMm = 45, kReachMm = 40;  ///< of the scan, for the part of surface it can meet
constexpr double kPullSoftMm = 2;  ///< beyond a patch's border where its pull has half its weight
/// What the scan is held to be worth at first. Little: once a fit has followed what a scanner gets wrong over
/// centimetres, its residuals no longer show that.
constexpr double kFirstSamples = 100;
constexpr double kFewestSamples = 20;
constexpr double kUnlikelyBend = 0.75;  ///< share of the largest bending, from which the user is warned

double squared(double x) { return x * x; }

}  // namespace

ModelFit::ModelFit(const UpdateModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
                   const UpdateSettings& settings, std::uint64_t seed)
    : model_(model),
      settings_(settings),
      pose_(scanFromPreopStart.inverse()),
      scan_(chooseScanPoints(scan, settings.samplePoints, seed)),
      samples_(std::min(settings.effectiveSamples, kFirstSamples)),
      surface_(model, settings) {
  coefficients_ = VectorXd::Zero(model.responses().loads());
  strength_ = VectorXd::Ones(model.responses().centres.rows());
}

/// Coefficient of each load at a whitened value of 1 and a prior bending of 1 mm RMS.
VectorXd ModelFit::perLoad() const {
  VectorXd loads = seen_;
  for (Index c = 0; c < strength_.size(); ++c) loads.segment<3>(3 * c) *= strength_[c];
  return loads / std::sqrt(loads.cwiseAbs2().dot(model_.responses().rmsMm.cwiseAbs2()));
}

/// Which part of the surface the scan can meet, and which load centres, where they are now, lie under it: as
/// many points around them as a quarter of what scan points themselves have around them, so that strewn
/// outliers do not count.
void ModelFit::look(double reachMm) {
  const Points posed = transformed(scan_.crowd, pose_);
  const KdTree tree(posed);
  surface_.choose(coefficients_, tree, reachMm);
  std::vector<double> usual;
  for (Index i = 0; i < posed.rows(); i += std::max<Index>(1, posed.rows() / 200))
    usual.push_back(static_cast<double>(tree.within(posed.row(i).transpose(), settings_.reachMm).size()));
  const double enough = medianInPlace(usual) / 4;
  const Points& centres = surface_.centres();
  seen_.resize(model_.responses().loads());
  for (Index c = 0; c < centres.rows(); ++c) {
    const bool under =
        static_cast<double>(tree.within(centres.row(c).transpose(), settings_.reachMm).size()) >= enough;
    seen_.segment<3>(3 * c).setConstant(under ? settings_.seenLoadShare : 1);
  }
}

Vector3d ModelFit::posed(std::size_t j) const {
  return pose_ * Vector3d(scan_.points.row(static_cast<Index>(j)).transpose());
}

void ModelFit::correspond(std::size_t count) {
  found_.resize(count);
  forEachChunk(count, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j) {
      const Vector3d y = posed(j);
      found_[j].at = surface_.closest(y);
      found_[j].residual = found_[j].at.normal.dot(y - found_[j].at.point);
    }
  });
  std::vector<double> sizes(count);
  for (std::size_t j = 0; j < count; ++j) sizes[j] = std::abs(found_[j].residual);
  const double width =
      std::max(6.0, 3 * medianInPlace(sizes));  // Welsch; generous while the bending is unknown
  weights_.assign(count, 0);
  double sum = 0, squares = 0;
  for (std::size_t j = 0; j < count; ++j) {
    if (found_[j].at.distance >= 3 * width + 5) continue;
    weights_[j] = std::exp(-squared(found_[j].residual / width));
    sum += weights_[j];
    squares += weights_[j] * squared(found_[j].residual);
  }
  rmsMm_ = sum > 0 ? std::sqrt(squares / sum) : 0;
}

/// How many independent measurements the scan is worth: n points whose residuals correlate by r on average
/// are worth n / (1 + n r) (Kish's design effect). r from sums of residuals over cells of space.
void ModelFit::learnSamples() {
  std::map<std::array<int, 3>, double> cells;
  double own = 0;
  for (std::size_t j = 0; j < found_.size(); ++j) {
    const Vector3d y = posed(j) / kCellMm;
    const double r = weights_[j] * found_[j].residual;
    own += squared(r);
    cells[{static_cast<int>(std::floor(y[0])), static_cast<int>(std::floor(y[1])),
           static_cast<int>(std::floor(y[2]))}] += r;
  }
  double together = 0;
  for (const auto& [cell, residual] : cells) together += squared(residual);
  const double n = static_cast<double>(found_.size());
  const double correlation = std::max(0.0, (together / own - 1) / n);
  const double learnt = 1 / (1 / static_cast<double>(scan_.points.rows()) + correlation);
  samples_ = std::sqrt(
      samples_ * std::clamp(learnt, kFewestSamples, std::max(kFewestSamples, settings_.effectiveSamples)));
}

/// along' dF(place): how the loads' displacements there, small beside what there is, go along a direction.
void ModelFit::placeRow(int place, const Vector3d& along, double* row) const {
  const LoadResponses& loads = model_.responses();
  const MeshPlaces& places = model_.places();
  const int vertex = surface_.vertex(place);
  const Vector3d before = surface_.turn(place).transpose() * along;
  Eigen::VectorXf sum = Eigen::VectorXf::Zero(loads.loads());
  for (Index k = 0; k < places.nodes().cols(); ++k) {
    const Index column = 3 * static_cast<Index>(places.nodes()(vertex, k));
    for (Index a = 0; a < 3; ++a)
      sum += static_cast<float>(places.weights()(vertex, k) * before[a]) * loads.responses.col(column + a);
  }
  Eigen::Map<VectorXd>(row, loads.loads()) = sum.cast<double>();
}

/// One equation: scan point j meets the surface at `meeting`, along a direction.
void ModelFit::meetingRow(std::size_t j, const SurfaceMeeting& meeting, const Vector3d& along,
                          const Vector3d& centre, double weight, double* row) const {
  const Index loads = model_.responses().loads();
  const Vector3d y = posed(j);
  placeRow(meeting.place, along, row);
  Eigen::Map<Vector3d>(row + loads) = -(y - centre).cross(along);
  Eigen::Map<Vector3d>(row + loads + 3) = -along;
  row[loads + 6] = along.dot(y - meeting.point) + Eigen::Map<VectorXd>(row, loads).dot(coefficients_);
  Eigen::Map<VectorXd>(row, loads + 7) *= weight;
}

/// Takes equations, a column each, into the normal equations; the last entry of a column is its right-hand
/// side.
void ModelFit::addRows(Eigen::MatrixXd& rows) {
  const Index loads = model_.responses().loads(), size = loads + 6;
  rows.topRows(loads).array().colwise() *= perLoad().array();
  const Eigen::MatrixXd products = outerSquare(rows);
  normal_ += products.topLeftCorner(size, size);
  right_ += products.col(size).head(size);
}

/// Builds the normal equations and solves them.
double ModelFit::step(std::size_t count) {
  correspond(count);
  if (rmsMm_ > 0) noiseMm_ = std::max(settings_.noiseFloorMm, rmsMm_);
  const Index size = model_.responses().loads() + 6;
  const double perPoint = std::sqrt(samples_ / static_cast<double>(count)) / noiseMm_;
  Vector3d centre =
      pose_ * Vector3d(scan_.points.topRows(static_cast<Index>(count)).colwise().mean().transpose());
  Eigen::MatrixXd rows(size + 1, static_cast<Index>(count));
  forEachChunk(count, 32, [&](std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j)
      meetingRow(j, found_[j].at, found_[j].at.normal, centre, std::sqrt(weights_[j]) * perPoint,
                 rows.col(static_cast<Index>(j)).data());
  });
  normal_.setZero(size, size);
  right_.setZero(size);
  addRows(rows);
  addPatches(count, centre, squared(perPoint) * settings_.patchWeight);
  return solve(centre);
}

/// Painted scan points that lie beyond their patch's border on the surface are pulled towards it along the
/// surface; within it a patch says nothing that closest places do not. Pulls set in smoothly.
void ModelFit::addPatches(std::size_t count, const Vector3d& centre, double weight) {
  const Index size = model_.responses().loads() + 6;
  for (std::size_t patch = 0; patch < surface_.patches().size(); ++patch) {
    const int label = surface_.patches()[patch].first;
    struct Pull {
      std::size_t point;
      SurfaceMeeting border;
      Vector3d along;
      double distance;
    };
    std::vector<Pull> pulls;
    std::vector<double> distances;
    for (std::size_t j = 0; j < count; ++j) {
      if (scan_.labels[j] != label) continue;
      const Vector3d y = posed(j);
      Pull pull{j, surface_.closestOfPatch(patch, y), Vector3d::Zero(), 0};
      const Vector3d across = y - pull.border.point;
      const Vector3d& normal = pull.border.normal;
      pull.along = across - across.dot(normal) * normal;
      pull.distance = pull.along.norm();
      if (!(pull.distance > 1e-3)) continue;
      pull.along /= pull.distance;
      pulls.push_back(pull);
      distances.push_back(pull.distance);
    }
    if (pulls.empty()) continue;
    const double width = std::max(10.0, 3 * medianInPlace(distances));
    Eigen::MatrixXd rows(size + 1, static_cast<Index>(pulls.size()));
    forEachChunk(pulls.size(), 16, [&](std::size_t first, std::size_t last) {
      for (std::size_t m = first; m < last; ++m) {
        const Pull& pull = pulls[m];
        const double square = squared(pull.distance);
        const double share = std::exp(-square / squared(width)) * square / (square + squared(kPullSoftMm));
        meetingRow(pull.point, pull.border, pull.along, centre, std::sqrt(weight * share),
                   rows.col(static_cast<Index>(m)).data());
      }
    });
    addRows(rows);
  }
}

/// Solves for loads and the rest of the rigid motion, and takes both up. Returns the RMS change of what the
/// scan sees.
double ModelFit::solve(const Vector3d& centre) {
  const Index loads = model_.responses().loads();
  normal_.diagonal().head(loads).array() += 1 / squared(bendMm_);
  normal_.diagonal().tail<6>().array() += 1e-9;
  Eigen::MatrixXd lower = normal_;
  if (!choleskyInPlace(lower))
    throw std::runtime_error("the normal equations of the model update are not positive definite");
  Eigen::MatrixXd solution = right_;
  solveCholesky(lower, solution);
  invertCholesky(lower);
  covariance_ = std::move(lower);
  turnCentre_ = centre;
  const VectorXd whitened = solution.col(0).head(loads);
  const VectorXd before = coefficients_;
  coefficients_ += relax_ * (whitened.cwiseProduct(perLoad()) - coefficients_);
  const Vector3d turn = relax_ * solution.col(0).segment<3>(loads),
                 shift = relax_ * solution.col(0).tail<3>();
  learn(covariance_, whitened);
  const Isometry3d motion = motionAbout(centre, turn, shift);
  pose_ = motion * pose_;
  // What changed, at the vertices that stand for the scan: the field's change and the pose's together.
  double sum = 0;
  std::size_t used = 0;
  VectorXd row(loads);
  const VectorXd change = coefficients_ - before;
  for (std::size_t j = 0; j < found_.size(); j += std::max<std::size_t>(1, found_.size() / 64)) {
    const Vector3d y = posed(j), moved = motion.inverse() * y - y;
    for (Index a = 0; a < 3; ++a) {
      placeRow(found_[j].at.place, Vector3d::Unit(a), row.data());
      sum += squared(row.dot(change) + moved[a]);
    }
    ++used;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, used))) / relax_;
}

/// MacKay's evidence update of the prior's width, and which centres press.
void ModelFit::learn(const Eigen::MatrixXd& covariance, const VectorXd& whitened) {
  const Index loads = model_.responses().loads();
  const double determined =
      static_cast<double>(loads) - covariance.diagonal().head(loads).sum() / squared(bendMm_);
  known_ = std::max(determined, 1.0);
  bendMm_ = std::clamp(std::sqrt(whitened.squaredNorm() / known_), 0.2, settings_.maxBendMm);
  // Few places press hard, most do not: each centre's loads are Student's t beforehand, a normal distribution
  // of unknown width, whose expectation given the data replaces it (the E and M steps of Lange et al. 1989).
  const double freedom = settings_.loadFreedom;
  for (Index c = 0; c < strength_.size(); ++c) {
    const double size =
        whitened.segment<3>(3 * c).squaredNorm() + covariance.diagonal().segment<3>(3 * c).sum();
    const double expected = squared(strength_[c]) * size / squared(bendMm_);
    strength_[c] = std::sqrt((freedom + expected) / (freedom + 3));
  }
}

/// All that follows from where the fit stands.
void ModelFit::finish(UpdateResult& result) const {
  BentNodes bent = bendAll(model_, coefficients_, settings_.trueTurns);
  result.scanFromPreop = pose_.inverse();
  result.displacements = std::move(bent.displacements);
  result.turns = std::move(bent.turns);
  result.coefficients = coefficients_;
  result.covariance = covariance_;
  result.coefficientScale = perLoad();
  result.turnCentre = turnCentre_;
  result.rmsMm = rmsMm_;
  result.noiseMm = noiseMm_;
  result.effectiveSamples = samples_;
  result.bendMm = bendMm_;
  result.effectiveParameters = known_;
  describeDeformation(model_.responses().mesh, result);
  if (bendMm_ >= kUnlikelyBend * settings_.maxBendMm)
    result.warnings.push_back(
        "the scan asks for more bending than is likely: its errors may go together over wide "
        "areas, or the liver may have turned far; expected errors are too small then");
}

UpdateResult ModelFit::run(const Progress& progress, const UpdateObserver& observer) {
  const std::size_t all = static_cast<std::size_t>(scan_.points.rows());
  std::size_t count = std::min<std::size_t>(all, kCoarsePoints);
  UpdateResult result;
  result.stopReason = "the largest number of iterations was reached";
  double last = INFINITY;
  look(kFirstReachMm);
  for (int iteration = 1; iteration <= settings_.maxIterations; ++iteration) {
    progress.report(static_cast<double>(iteration) / (settings_.maxIterations + 1), "Fitting the model");
    if (iteration == 4 || iteration == 8) look(kReachMm);
    const double change = step(count);
    if (iteration > kRoughIterations) learnSamples();
    result.iterations = iteration;
    surface_.bend(coefficients_);
    if (iteration > kRoughIterations)
      relax_ = change > 0.9 * last ? std::max(0.4, 0.7 * relax_) : std::min(1.0, 1.15 * relax_);
    last = change;
    const auto soFar = [&] {
      UpdateResult now = result;
      finish(now);
      return now;
    };
    if (observer && !observer({iteration, rmsMm_, bendMm_, change, soFar})) {
      result.stopReason = "stopped by the user";
      break;
    }
    sinceTreesMm_ += change;
    if (sinceTreesMm_ > kStaleMm) {
      surface_.refreshTrees();
      sinceTreesMm_ = 0;
    }
    if (iteration < kRoughIterations + 3) continue;
    if (count < all && (change < 2 * kSettledMm || iteration > settings_.maxIterations - 8)) {
      count = all;
      continue;
    }
    if (count == all && change < kSettledMm) {
      result.converged = true;
      result.stopReason = "the fitted surface has settled";
      break;
    }
  }
  correspond(all);
  finish(result);
  return result;
}

}  // namespace falciform
