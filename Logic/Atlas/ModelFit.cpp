#include "Logic/Atlas/ModelFit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Median.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 256;
constexpr int kCoarsePoints = 800;
constexpr double kStaleMm = 0.15;    ///< RMS motion after which trees are made anew; vertices are 2 mm apart
constexpr double kSettledMm = 0.02;  ///< RMS change of the fitted surface under the scan by one step

double squared(double x) { return x * x; }

}  // namespace

ModelFit::ModelFit(const UpdateModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
                   const UpdateSettings& settings, std::uint64_t seed)
    : model_(model), settings_(settings), pose_(scanFromPreopStart.inverse()) {
  choosePoints(scan, seed);
  coefficients_ = VectorXd::Zero(model.responses().loads());
  refreshSurface();
  refreshTrees();
}

void ModelFit::choosePoints(const Surface& scan, std::uint64_t seed) {
  checkSurface(scan, "the scan");
  std::vector<int> rows(static_cast<std::size_t>(scan.size()));
  std::iota(rows.begin(), rows.end(), 0);
  Draws draws(seed);
  for (std::size_t i = rows.size(); i > 1; --i)
    std::swap(rows[i - 1], rows[static_cast<std::size_t>(draws.uniform() * static_cast<double>(i))]);
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(4 * settings_.samplePoints)));
  rows = withoutStragglers(scan.points, KdTree(scan.points), rows);
  if (rows.size() < 10)
    throw InputError("the scan has " + std::to_string(rows.size()) +
                     " usable points; a model update needs at least 10");
  crowd_ = scan.points(rows, Eigen::all);
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(settings_.samplePoints)));
  points_ = scan.points(rows, Eigen::all);
  for (const int row : rows) labels_.push_back(scan.patchAt(row));
}

/// Coefficient of each load at a whitened value of 1 and a prior bending of 1 mm RMS.
VectorXd ModelFit::perLoad() const {
  const double total = std::sqrt(seen_.cwiseAbs2().dot(model_.responses().rmsMm.cwiseAbs2()));
  return seen_ / total;
}

void ModelFit::refreshSurface() {
  const LoadResponses& loads = model_.responses();
  const Index nodes = loads.mesh.nodes();
  nodal_.resize(nodes, 3);
  const Eigen::VectorXf q = coefficients_.cast<float>();
  Eigen::Map<VectorXd> flat(nodal_.data(), nodal_.size());
  forEachChunk(static_cast<std::size_t>(3 * nodes), 4096, [&](std::size_t first, std::size_t last) {
    const auto at = static_cast<Index>(first), count = static_cast<Index>(last - first);
    flat.segment(at, count) = (loads.responses.middleCols(at, count).transpose() * q).cast<double>();
  });
  moved_ = {};
  moved_.triangles = model_.fine().triangles;
  moved_.points = model_.fine().points + Points(model_.places().interpolate(nodal_));
}

/// What closest points are sought with: normals and trees of the surface as it is now.
void ModelFit::refreshTrees() {
  sinceTreesMm_ = 0;
  normals_ = vertexNormals(moved_);
  tree_ = KdTree(moved_.points);
  patches_.clear();
  if (settings_.patchWeight > 0)
    for (const int label : patchLabels(model_.fine()))
      patches_.emplace_back(label, KdTree(moved_.points, pointsOfPatch(model_.fine(), label)));
}

/// Which load centres, where they are now, lie under the scan: as many points around them as a quarter of
/// what scan points themselves have around them, so that strewn outliers do not count.
void ModelFit::refreshSeen() {
  const Points posed = transformed(crowd_, pose_);
  const KdTree tree(posed);
  std::vector<double> usual;
  for (Index i = 0; i < posed.rows(); i += std::max<Index>(1, posed.rows() / 200))
    usual.push_back(static_cast<double>(tree.within(posed.row(i).transpose(), settings_.reachMm).size()));
  const double enough = medianInPlace(usual) / 4;
  const Points centres = model_.responses().centres + Points(model_.centres().interpolate(nodal_));
  seen_.resize(model_.responses().loads());
  for (Index c = 0; c < centres.rows(); ++c) {
    const bool under =
        static_cast<double>(tree.within(centres.row(c).transpose(), settings_.reachMm).size()) >= enough;
    seen_.segment<3>(3 * c).setConstant(under ? settings_.seenLoadShare : 1);
  }
}

void ModelFit::correspond(std::size_t count) {
  found_.resize(count);
  forEachChunk(count, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j) {
      const Vector3d y = pose_ * Vector3d(points_.row(static_cast<Index>(j)).transpose());
      const Neighbour nearest = tree_.nearest(y);
      const Vector3d x = moved_.points.row(nearest.index).transpose();
      found_[j] = {nearest.index, normals_.row(nearest.index).dot((y - x).transpose()),
                   std::sqrt(nearest.squaredDistance)};
    }
  });
  std::vector<double> sizes(count);
  for (std::size_t j = 0; j < count; ++j) sizes[j] = std::abs(found_[j].residual);
  const double width =
      std::max(6.0, 3 * medianInPlace(sizes));  // Welsch; generous while the bending is unknown
  weights_.assign(count, 0);
  double sum = 0, squares = 0;
  for (std::size_t j = 0; j < count; ++j) {
    if (found_[j].distance >= 3 * width + 5) continue;
    weights_[j] = std::exp(-squared(found_[j].residual / width));
    sum += weights_[j];
    squares += weights_[j] * squared(found_[j].residual);
  }
  rmsMm_ = sum > 0 ? std::sqrt(squares / sum) : 0;
}

/// along' F(vertex), whitened: the loads' displacements at a surface vertex along a direction.
void ModelFit::vertexRow(int vertex, const Vector3d& along, double* row) const {
  const LoadResponses& loads = model_.responses();
  const MeshPlaces& places = model_.places();
  Eigen::VectorXf sum = Eigen::VectorXf::Zero(loads.loads());
  for (Index k = 0; k < places.nodes().cols(); ++k) {
    const Index column = 3 * static_cast<Index>(places.nodes()(vertex, k));
    for (Index a = 0; a < 3; ++a)
      sum += static_cast<float>(places.weights()(vertex, k) * along[a]) * loads.responses.col(column + a);
  }
  Eigen::Map<VectorXd>(row, loads.loads()) = sum.cast<double>();
}

/// One equation: scan point j meets the surface at `vertex`, along a direction.
void ModelFit::meetingRow(std::size_t j, int vertex, const Vector3d& along, const Vector3d& centre,
                          double weight, double* row) const {
  const Index loads = model_.responses().loads();
  const Vector3d y = pose_ * Vector3d(points_.row(static_cast<Index>(j)).transpose());
  vertexRow(vertex, along, row);
  Eigen::Map<Vector3d>(row + loads) = -(y - centre).cross(along);
  Eigen::Map<Vector3d>(row + loads + 3) = -along;
  row[loads + 6] = along.dot(y - Vector3d(model_.fine().points.row(vertex).transpose()));
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
  const double perPoint = std::sqrt(settings_.effectiveSamples / static_cast<double>(count)) / noiseMm_;
  Vector3d centre = pose_ * Vector3d(points_.topRows(static_cast<Index>(count)).colwise().mean().transpose());
  Eigen::MatrixXd rows(size + 1, static_cast<Index>(count));
  forEachChunk(count, 32, [&](std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j)
      meetingRow(j, found_[j].vertex, normals_.row(found_[j].vertex).transpose(), centre,
                 std::sqrt(weights_[j]) * perPoint, rows.col(static_cast<Index>(j)).data());
  });
  normal_.setZero(size, size);
  right_.setZero(size);
  addRows(rows);
  addPatches(count, centre, squared(perPoint) * settings_.patchWeight);
  return solve(centre);
}

/// Painted scan points are pulled to the nearest place of the same patch, along all three axes.
void ModelFit::addPatches(std::size_t count, const Vector3d& centre, double weight) {
  const Index size = model_.responses().loads() + 6;
  for (const auto& [label, tree] : patches_) {
    std::vector<std::size_t> members;
    std::vector<Neighbour> nearest;
    std::vector<double> distances;
    for (std::size_t j = 0; j < count; ++j) {
      if (labels_[j] != label) continue;
      members.push_back(j);
      nearest.push_back(tree.nearest(pose_ * Vector3d(points_.row(static_cast<Index>(j)).transpose())));
      distances.push_back(std::sqrt(nearest.back().squaredDistance));
    }
    if (members.empty()) continue;
    std::vector<double> sorted = distances;
    const double width = std::max(10.0, 3 * medianInPlace(sorted));
    Eigen::MatrixXd rows(size + 1, static_cast<Index>(3 * members.size()));
    forEachChunk(members.size(), 16, [&](std::size_t first, std::size_t last) {
      for (std::size_t m = first; m < last; ++m) {
        const double share = std::sqrt(weight * std::exp(-squared(distances[m] / width)));
        for (Index a = 0; a < 3; ++a)
          meetingRow(members[m], nearest[m].index, Vector3d::Unit(a), centre, share,
                     rows.col(static_cast<Index>(3 * m) + a).data());
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
  coefficients_ = whitened.cwiseProduct(perLoad());
  const Vector3d turn = solution.col(0).segment<3>(loads), shift = solution.col(0).tail<3>();
  learn(covariance_, whitened);
  const double angle = turn.norm();
  Isometry3d motion = Isometry3d::Identity();
  if (angle > 0) motion.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  motion.translation() = centre + shift - motion.linear() * centre;
  pose_ = motion * pose_;
  // What changed, at the vertices that stand for the scan: the field's change and the pose's together.
  double sum = 0;
  std::size_t used = 0;
  VectorXd row(loads);
  const VectorXd change = coefficients_ - before;
  for (std::size_t j = 0; j < found_.size(); j += std::max<std::size_t>(1, found_.size() / 64)) {
    const Vector3d y = pose_ * Vector3d(points_.row(static_cast<Index>(j)).transpose());
    const Vector3d posed = motion.inverse() * y - y;
    for (Index a = 0; a < 3; ++a) {
      vertexRow(found_[j].vertex, Vector3d::Unit(a), row.data());
      sum += squared(row.dot(change) + posed[a]);
    }
    ++used;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, used)));
}

/// MacKay's evidence update of the prior's width.
void ModelFit::learn(const Eigen::MatrixXd& covariance, const VectorXd& whitened) {
  const Index loads = model_.responses().loads();
  const double determined =
      static_cast<double>(loads) - covariance.diagonal().head(loads).sum() / squared(bendMm_);
  known_ = std::max(determined, 1.0);
  bendMm_ = std::clamp(std::sqrt(whitened.squaredNorm() / known_), 0.2, settings_.maxBendMm);
}

/// All that follows from where the fit stands.
void ModelFit::finish(UpdateResult& result) const {
  result.scanFromPreop = pose_.inverse();
  result.displacements = nodal_;
  result.coefficients = coefficients_;
  result.covariance = covariance_;
  result.coefficientScale = perLoad();
  result.turnCentre = turnCentre_;
  result.rmsMm = rmsMm_;
  result.noiseMm = noiseMm_;
  result.bendMm = bendMm_;
  result.effectiveParameters = known_;
  result.minDetJ = checkDeformation(model_.responses().mesh, nodal_).minDetJ;
  result.largestMm = nodal_.rowwise().norm().maxCoeff();
  if (!result.converged)
    result.warnings.push_back("the model had not settled after " + std::to_string(result.iterations) +
                              " iterations");
  if (!(result.minDetJ > 0))
    result.warnings.push_back(
        "the fitted deformation folds tissue over itself somewhere: do not trust it there");
}

UpdateResult ModelFit::run(const Progress& progress, const UpdateObserver& observer) {
  const std::size_t all = static_cast<std::size_t>(points_.rows());
  std::size_t count = std::min<std::size_t>(all, kCoarsePoints);
  UpdateResult result;
  result.stopReason = "the largest number of iterations was reached";
  refreshSeen();
  for (int iteration = 1; iteration <= settings_.maxIterations; ++iteration) {
    progress.report(static_cast<double>(iteration) / (settings_.maxIterations + 1), "Fitting the model");
    if (iteration == 6 || iteration == 11) refreshSeen();
    const double change = step(count);
    result.iterations = iteration;
    refreshSurface();
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
    if (sinceTreesMm_ > kStaleMm) refreshTrees();
    if (iteration < 12) continue;
    if (count < all && (change < 5 * kSettledMm || iteration > settings_.maxIterations - 8)) {
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
