#include "Logic/Registration/ElasticFit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "Logic/Core/Median.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/ElasticEquations.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 128;   // fixed: sums are formed in one order whatever the number of threads
constexpr double kPaintingMm = 3;     // how well a patch's border is painted
constexpr double kPatchScaleMm = 10;  // Welsch scale of the pull to one's own label, at least
constexpr double kScoreScaleMm = 5;
constexpr double kWalkMm = 0.5;  // after a step no longer than this a nearest place is walked to, not
                                 // searched; longer walks end beside the nearest on livers that bent much
// Before the scan has spoken: strains as livers show in surgery, worth so many modes' evidence.
constexpr double kUsualStrain = 0.012, kUsualCount = 0.3, kLargestStrain = 0.018;
constexpr int kLearningSteps = 8;  // what it learns later would move the pose by hundredths of a millimetre
constexpr double kLeastResidualMm = 0.1, kLargestResidualMm = 4;
using Unknowns = ElasticEquations::Unknowns;

/// A scan point and where it belongs: plane residuals for all, and three coordinates for labelled ones.
struct Match {
  PreparedPreop::Place place{Vector3d::Zero(), Vector3d::Zero(), -1};
  int point = -1,
      own = -1;  ///< nearest pre-op point; nearest of the same label, -1: unlabelled or there already
  double distance = 0, ownDistance = 0;  ///< along the normal, signed; to `own`
};

ElasticModes::Energy covarianceOf(const Eigen::LLT<ElasticModes::Energy>& precision) {
  return precision.solve(ElasticModes::Energy::Identity());
}

double welsch(double distance, double scale) {
  const double r = distance / scale;
  return std::exp(-r * r);
}

/// The points in their own principal axes, each turned so that the points lean to its positive side: cells
/// cut there do not depend on the frame that the points came in.
Points inOwnAxes(const Points& points) {
  const Points about = points.rowwise() - points.colwise().mean();
  Eigen::SelfAdjointEigenSolver<Matrix3d> axes;
  axes.computeDirect(about.transpose() * about);
  Points own = about * axes.eigenvectors();
  for (int a = 0; a < 3; ++a)
    if (own.col(a).array().cube().sum() < 0) own.col(a) *= -1;
  return own;
}

/// Everything that one Gauss-Newton step needs, and its state.
class Fit {
 public:
  Fit(const PreparedPreop& preop, const LabelledSource& scan, const ElasticFitPlan& settings,
      const Isometry3d& start)
      : preop_(preop), scan_(scan), settings_(settings), pose(start), matches_(scan.labels.size()) {
    shareCells();
  }

  /// `near`: the last step was short, so each point's place is near its last one.
  void match(bool near);
  /// Solves for the bending from scratch and moves its rigid part into the pose.
  void step();
  /// Strain and residual that make what was seen most probable.
  void learn();
  [[nodiscard]] double rms() const;
  [[nodiscard]] double score() const;

  const PreparedPreop& preop_;
  const LabelledSource& scan_;
  ElasticFitPlan settings_;
  Isometry3d pose;
  ElasticModes::Coefficients bending = settings_.bending;
  double damping = 1;  ///< share of a Gauss-Newton step that is made
  [[nodiscard]] const Eigen::LLT<ElasticModes::Energy>& factors() const { return factors_; }
  double strain = settings_.strain, residualMm = settings_.residualMm;

 private:
  void shareCells();
  void addChunk(std::size_t begin, std::size_t end, double weight, ElasticEquations& equations) const;
  std::vector<Match> matches_;
  std::vector<int> cells_;      // of each point
  std::vector<double> shares_;  // of each point in its cell: 1 / count
  int cellCount_ = 0;
  double scale_ = 1, patchScale_ = 1;
  Eigen::LLT<ElasticModes::Energy> factors_;
};

void Fit::shareCells() {
  using Cell = std::array<int, 3>;
  const auto hash = [](const Cell& cell) {
    return static_cast<std::size_t>(cell[0]) * 73856093U ^ static_cast<std::size_t>(cell[1]) * 19349663U ^
           static_cast<std::size_t>(cell[2]) * 83492791U;
  };
  std::unordered_map<Cell, int, decltype(hash)> numbers(scan_.labels.size(), hash);
  std::vector<int> counts;
  const Points places = inOwnAxes(scan_.points);
  for (Index i = 0; i < places.rows(); ++i) {
    Cell cell{};
    for (int a = 0; a < 3; ++a)
      cell[static_cast<std::size_t>(a)] = static_cast<int>(std::floor(places(i, a) / settings_.cellMm));
    const int number = numbers.try_emplace(cell, static_cast<int>(numbers.size())).first->second;
    cells_.push_back(number);
    counts.resize(numbers.size());
    ++counts[static_cast<std::size_t>(number)];
  }
  cellCount_ = static_cast<int>(counts.size());
  for (const int cell : cells_) shares_.push_back(1.0 / counts[static_cast<std::size_t>(cell)]);
}

void Fit::match(bool near) {
  const LabelledTarget& target = preop_.target();
  forEachChunk(matches_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Match& m = matches_[i];
      const Vector3d y = pose * scan_.points.row(static_cast<Index>(i)).transpose();
      const Vector3d at = m.point < 0 ? y : m.place.point;
      const Vector3d straight = y - preop_.modes().displacement(bending, at);
      if (near) {
        m.place = preop_.placeByWalk(m.place, m.point, straight);
      } else {
        const int guess = m.point < 0 ? preop_.coarse().rowNear(straight.cast<float>()) : m.point;
        m.point = target.closest(straight, 0, 1, guess).index;
        m.place = preop_.placeAround(m.point, straight);
      }
      m.distance = m.place.normal.dot(straight - m.place.point);
      const int lastOwn = m.own;
      m.own = -1;
      m.ownDistance = 0;
      if (scan_.labels[i] == 0 || target.labelOf(m.point) == scan_.labels[i]) continue;
      const Neighbour own = target.closestOfLabel(straight, scan_.labels[i], lastOwn);
      m.own = own.index;
      m.ownDistance = std::sqrt(own.squaredDistance);
    }
  });
  std::vector<double> distances, own;
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    distances.push_back(std::abs(matches_[i].distance));
    if (scan_.labels[i] > 0) own.push_back(matches_[i].ownDistance);  // 0: there already
  }
  scale_ = std::max(settings_.robustScaleMm, 3 * medianInPlace(distances));
  patchScale_ = std::max(kPatchScaleMm, 3 * medianInPlace(own));
}

void Fit::addChunk(std::size_t begin, std::size_t end, double weight, ElasticEquations& equations) const {
  const Points& points = preop_.target().points();
  ElasticEquations::Observations seen(static_cast<Index>(2 * (end - begin)));
  for (std::size_t i = begin; i < end; ++i) {
    const Match& m = matches_[i];
    const Vector3d y = pose * scan_.points.row(static_cast<Index>(i)).transpose();
    const Vector3d &x = m.place.point, &n = m.place.normal;
    seen.addAlong(x, n, n.dot(y - x), weight * shares_[i] * welsch(m.distance, scale_));
    if (m.own < 0) continue;
    const Vector3d own = points.row(m.own);
    seen.addWhole(own, y - own,
                  shares_[i] * settings_.patchWeight * welsch(m.ownDistance, patchScale_) /
                      (kPaintingMm * kPaintingMm));
  }
  equations.add(preop_.modes(), seen);
}

void Fit::step() {
  const std::size_t n = matches_.size();
  const double weight = 1 / (residualMm * residualMm);
  std::vector<ElasticEquations> parts((n + kChunk - 1) / kChunk);
  forEachChunk(n, kChunk, [&](std::size_t begin, std::size_t end) {
    addChunk(begin, end, weight, parts[begin / kChunk]);
  });
  ElasticEquations total;
  for (const ElasticEquations& part : parts) total.add(part);
  ElasticModes::Energy matrix = total.matrix();
  matrix += preop_.modes().energy() / (strain * strain);
  matrix.diagonal().array() += 1e-12 * matrix.trace();
  factors_.compute(matrix);
  const Unknowns q = factors_.solve(total.right());
  bending += damping * (Eigen::Map<const ElasticModes::Coefficients>(q.data()) - bending);
  const Isometry3d rigid = preop_.modes().rigidPart(bending);
  bending = preop_.modes().without(rigid, bending);
  pose = rigid.inverse() * pose;
  pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
}

void Fit::learn() {
  std::vector<double> sums(static_cast<std::size_t>(cellCount_)), weights(sums.size());
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    const auto cell = static_cast<std::size_t>(cells_[i]);
    const double weight = shares_[i] * welsch(matches_[i].distance, scale_);
    sums[cell] += weight * matches_[i].distance;
    weights[cell] += weight;
  }
  double squared = 0, observations = 0;  // a cell counts by the share of it that is no outlier
  for (std::size_t cell = 0; cell < sums.size(); ++cell) {
    if (weights[cell] <= 0) continue;
    squared += sums[cell] * sums[cell] / weights[cell];
    observations += weights[cell];
  }
  const Eigen::Map<const Unknowns> q(bending.data());
  const ElasticModes::Energy& energy = preop_.modes().energy();
  const double free = energy.cwiseProduct(covarianceOf(factors_)).sum() / (strain * strain);
  const double determined = std::clamp(ElasticModes::kNonRigid - free, 1.0, double{ElasticModes::kNonRigid});
  strain =
      std::sqrt((q.dot(energy * q) + kUsualCount * kUsualStrain * kUsualStrain) / (determined + kUsualCount));
  strain = std::min(strain, kLargestStrain);
  residualMm = std::clamp(std::sqrt(squared / std::max(1.0, observations - 6 - determined)), kLeastResidualMm,
                          kLargestResidualMm);
}

double Fit::rms() const {
  double sum = 0;
  for (const Match& m : matches_) sum += m.distance * m.distance;
  return std::sqrt(sum / static_cast<double>(matches_.size()));
}

double Fit::score() const {
  const auto term = [](double distance) {
    return distance * distance / (distance * distance + kScoreScaleMm * kScoreScaleMm);
  };
  double sum = 0, weights = 0;
  for (const Match& m : matches_) {
    sum += term(m.distance);
    weights += 1;
    if (m.own < 0) continue;
    sum += 2 * term(m.ownDistance);
    weights += 2;
  }
  const Eigen::Map<const Unknowns> q(bending.data());
  const double price = q.dot(preop_.modes().energy() * q) / (strain * strain * cellCount_);
  return sum / weights + price * residualMm * residualMm / (kScoreScaleMm * kScoreScaleMm);
}

}  // namespace

ElasticFitResult fitElastic(const PreparedPreop& preop, const LabelledSource& scan,
                            const ElasticFitPlan& settings, const Isometry3d& preopFromScan,
                            const Progress& progress, const IterationObserver& observer) {
  Fit fit(preop, scan, settings, preopFromScan);
  ElasticFitResult result;
  const Points corners = boxCorners(scan.points);
  Points lastStep;
  bool learnt = !settings.learn;  // strain has settled
  fit.match(false);
  for (int step = 0; step < settings.maxIterations; ++step) {
    const Points before = transformed(corners, fit.pose);
    const double strainBefore = fit.strain;
    IterationRecord record;
    record.iteration = settings.firstIteration + step;
    record.rmsMm = fit.rms();
    record.patchWeight = settings.patchWeight;
    fit.step();
    const Points made = transformed(corners, fit.pose) - before;
    record.motionMm = made.rowwise().norm().maxCoeff();
    const bool still = record.motionMm < settings.motionToleranceMm;
    // What it would learn from places that have not moved is what it learnt before.
    const bool learning = settings.learn && step < kLearningSteps && !(still && learnt);
    if (!still || learning) fit.match(record.motionMm < kWalkMm);
    if (learning) fit.learn();
    record.preopFromScan = fit.pose;
    // Matches that change to and fro would have the fit step to and fro for ever; steps that keep their
    // direction are too short.
    if (step > 0) {
      const double turn = made.cwiseProduct(lastStep).sum() / (made.norm() * lastStep.norm() + 1e-12);
      fit.damping = turn < 0     ? std::max(0.25, 0.6 * fit.damping)
                    : turn > 0.7 ? std::min(2.5, 1.4 * fit.damping)
                                 : 1;
    }
    lastStep = made;
    result.pose.history.push_back(record);
    if (observer) observer(record);
    progress.report(static_cast<double>(step) / settings.maxIterations, "settling");
    learnt = !settings.learn || step + 1 >= kLearningSteps ||
             std::abs(fit.strain - strainBefore) < 0.1 * strainBefore;
    if (still && learnt) {
      result.pose.converged = true;
      result.pose.stopReason = "nothing moved farther than the tolerance";
      break;
    }
  }
  if (!result.pose.converged) result.pose.stopReason = "the largest number of iterations was reached";
  result.pose.preopFromScan = fit.pose;
  result.bending = fit.bending;
  result.precision = fit.factors();
  result.score = fit.score();
  result.strain = fit.strain;
  result.residualMm = fit.residualMm;
  return result;
}

std::function<double(const Vector3d&)> expectedTargetError(const ElasticModes& modes,
                                                           const ElasticFitResult& fit) {
  struct Posterior {
    ElasticModes modes;
    ElasticModes::Coefficients bending;
    ElasticModes::Energy covariance;
  };
  auto posterior =
      std::make_shared<const Posterior>(Posterior{modes, fit.bending, covarianceOf(fit.precision)});
  return [posterior](const Vector3d& place) {
    constexpr int kM = ElasticModes::kMonomials;
    const ElasticModes::Monomials phi = posterior->modes.monomials(place);
    double squared = (posterior->bending.transpose() * phi).squaredNorm();
    for (int k = 0; k < 3; ++k) squared += phi.dot(posterior->covariance.block<kM, kM>(k * kM, k * kM) * phi);
    return std::sqrt(squared);
  };
}

double expectedTargetErrorMean(const ElasticModes& modes, const ElasticFitResult& fit) {
  constexpr int kM = ElasticModes::kMonomials;
  const ElasticModes::Energy covariance = covarianceOf(fit.precision);
  double squared = std::pow(modes.rootMeanSquare(fit.bending), 2);
  for (int k = 0; k < 3; ++k)
    squared += modes.meanProducts().cwiseProduct(covariance.block<kM, kM>(k * kM, k * kM)).sum();
  return std::sqrt(squared);
}

}  // namespace falciform
