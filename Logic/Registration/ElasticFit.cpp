#include "Logic/Registration/ElasticFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 128;   // fixed: sums are formed in one order whatever the number of threads
constexpr double kPatchScaleMm = 10;  // Welsch scale of the pull to one's own label, at least
constexpr double kScoreScaleMm = 5;
using Unknowns = Eigen::Matrix<double, ElasticModes::kUnknowns, 1>;
using Rows = Eigen::Matrix<double, ElasticModes::kUnknowns, Eigen::Dynamic>;

/// A scan point and where it belongs: plane residuals for all, and three coordinates for labelled ones.
struct Match {
  int point = -1, own = -1;  ///< nearest pre-op point; nearest of the same label, -1: unlabelled
  double distance = 0, ownDistance = 0;
};

struct Sums {
  ElasticModes::Energy matrix = ElasticModes::Energy::Zero();  // lower triangle
  Unknowns right = Unknowns::Zero();
};

double welsch(double distance, double scale) {
  const double r = distance / scale;
  return std::exp(-r * r);
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Everything that one Gauss-Newton step needs, and its state.
class Fit {
 public:
  Fit(const PreparedPreop& preop, const LabelledSource& scan, const ElasticFitSettings& settings,
      const Isometry3d& start)
      : preop_(preop), scan_(scan), settings_(settings), pose(start), matches_(scan.labels.size()) {}

  void match();
  /// Solves for the bending from scratch and moves its rigid part into the pose.
  void step();
  [[nodiscard]] double rms() const;
  [[nodiscard]] double score() const;

  const PreparedPreop& preop_;
  const LabelledSource& scan_;
  ElasticFitSettings settings_;
  Isometry3d pose;
  ElasticModes::Coefficients bending = ElasticModes::Coefficients::Zero();
  [[nodiscard]] ElasticModes::Energy covariance() const {
    return factors_.solve(ElasticModes::Energy::Identity());
  }
  double strain = settings_.strain, residualMm = settings_.residualMm;

 private:
  void addChunk(std::size_t begin, std::size_t end, double weight, Sums& sums) const;
  std::vector<Match> matches_;
  double scale_ = 1, patchScale_ = 1;
  Eigen::LDLT<ElasticModes::Energy> factors_;
};

void Fit::match() {
  const LabelledTarget& target = preop_.target();
  const Points& points = target.points();
  forEachChunk(matches_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Match& m = matches_[i];
      const Vector3d y = pose * scan_.points.row(static_cast<Index>(i)).transpose();
      const Vector3d at = m.point < 0 ? y : points.row(m.point).transpose();
      const Vector3d straight = y - preop_.modes().displacement(bending, at);
      m.point = target.closest(straight, 0, 1, m.point).index;
      m.distance = std::abs(preop_.normals().row(m.point).dot((straight.transpose() - points.row(m.point))));
      if (scan_.labels[i] == 0) continue;
      const Neighbour own = target.closestOfLabel(straight, scan_.labels[i]);
      m.own = own.index;
      m.ownDistance = std::sqrt(own.squaredDistance);
    }
  });
  std::vector<double> distances, own;
  for (const Match& m : matches_) {
    distances.push_back(m.distance);
    if (m.own >= 0) own.push_back(m.ownDistance);
  }
  scale_ = std::max(settings_.robustScaleMm, 3 * medianOf(std::move(distances)));
  patchScale_ = std::max(kPatchScaleMm, 3 * medianOf(std::move(own)));
}

void Fit::addChunk(std::size_t begin, std::size_t end, double weight, Sums& sums) const {
  const Points& points = preop_.target().points();
  constexpr int kM = ElasticModes::kMonomials;
  Rows rows = Rows::Zero(ElasticModes::kUnknowns, static_cast<Index>(4 * (end - begin)));
  Index row = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Match& m = matches_[i];
    const Vector3d y = pose * scan_.points.row(static_cast<Index>(i)).transpose();
    const Vector3d x = points.row(m.point), n = preop_.normals().row(m.point);
    // The distance to the point itself, not to its plane, tells an outlier beside the surface.
    const double w = weight * welsch(m.distance, scale_), root = std::sqrt(w);
    const ElasticModes::Monomials phi = preop_.modes().monomials(x);
    for (int k = 0; k < 3; ++k) rows.col(row).segment<kM>(k * kM) = root * n[k] * phi;
    sums.right += root * n.dot(y - x) * rows.col(row);
    ++row;
    if (m.own < 0) continue;
    const Vector3d own = points.row(m.own);
    const double ownRoot = std::sqrt(weight * settings_.patchWeight * welsch(m.ownDistance, patchScale_));
    const ElasticModes::Monomials ownPhi = preop_.modes().monomials(own);
    for (int k = 0; k < 3; ++k) {
      rows.col(row).segment<kM>(k * kM) = ownRoot * ownPhi;
      sums.right += ownRoot * (y - own)[k] * rows.col(row);
      ++row;
    }
  }
  sums.matrix.selfadjointView<Eigen::Lower>().rankUpdate(rows.leftCols(row));
}

void Fit::step() {
  const std::size_t n = matches_.size();
  const double weight =
      std::min(settings_.independentSamples / static_cast<double>(n), 1.0) / (residualMm * residualMm);
  std::vector<Sums> parts((n + kChunk - 1) / kChunk);
  forEachChunk(n, kChunk, [&](std::size_t begin, std::size_t end) {
    addChunk(begin, end, weight, parts[begin / kChunk]);
  });
  Sums total;
  for (const Sums& part : parts) total.matrix += part.matrix, total.right += part.right;
  ElasticModes::Energy matrix = total.matrix.selfadjointView<Eigen::Lower>();
  matrix += preop_.modes().energy() / (strain * strain);
  matrix.diagonal().array() += 1e-12 * matrix.trace();
  factors_.compute(matrix);
  const Unknowns q = factors_.solve(total.right);
  bending = Eigen::Map<const ElasticModes::Coefficients>(q.data());
  const Isometry3d rigid = preop_.modes().rigidPart(bending);
  bending = preop_.modes().without(rigid, bending);
  pose = rigid.inverse() * pose;
  pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
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
  const double price = q.dot(preop_.modes().energy() * q) / (strain * strain * settings_.independentSamples);
  return sum / weights + price * residualMm * residualMm / (kScoreScaleMm * kScoreScaleMm);
}

}  // namespace

ElasticFitResult fitElastic(const PreparedPreop& preop, const LabelledSource& scan,
                            const ElasticFitSettings& settings, const Isometry3d& preopFromScan,
                            const Progress& progress, const IterationObserver& observer) {
  Fit fit(preop, scan, settings, preopFromScan);
  ElasticFitResult result;
  const Points corners = boxCorners(scan.points);
  fit.match();
  for (int step = 0; step < settings.maxIterations; ++step) {
    const Points before = transformed(corners, fit.pose);
    IterationRecord record;
    record.iteration = settings.firstIteration + step;
    record.rmsMm = fit.rms();
    record.patchWeight = settings.patchWeight;
    fit.step();
    fit.match();
    record.motionMm = (transformed(corners, fit.pose) - before).rowwise().norm().maxCoeff();
    record.preopFromScan = fit.pose;
    result.pose.history.push_back(record);
    if (observer) observer(record);
    if (step % 8 == 0) progress.report(static_cast<double>(step) / settings.maxIterations, "settling");
    if (record.motionMm < settings.motionToleranceMm) {
      result.pose.converged = true;
      result.pose.stopReason = "nothing moved farther than the tolerance";
      break;
    }
  }
  if (!result.pose.converged) result.pose.stopReason = "the largest number of iterations was reached";
  result.pose.preopFromScan = fit.pose;
  result.bending = fit.bending;
  result.covariance = fit.covariance();
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
  auto posterior = std::make_shared<const Posterior>(Posterior{modes, fit.bending, fit.covariance});
  return [posterior](const Vector3d& place) {
    constexpr int kM = ElasticModes::kMonomials;
    const ElasticModes::Monomials phi = posterior->modes.monomials(place);
    double squared = (posterior->bending.transpose() * phi).squaredNorm();
    for (int k = 0; k < 3; ++k) squared += phi.dot(posterior->covariance.block<kM, kM>(k * kM, k * kM) * phi);
    return std::sqrt(squared);
  };
}

}  // namespace falciform
