#include "Logic/Atlas/IncrementalUpdate.h"

#include <algorithm>
#include <cmath>

#include "Logic/Atlas/MethodResult.h"
#include "Logic/Atlas/ScanChoice.h"
#include "Logic/Atlas/SurfaceCounterparts.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Subdivision.h"
#include "Logic/Registration/Dirr.h"

namespace falciform {
namespace {

constexpr std::size_t kTogether = 48;  ///< forces solved for in one pass over the factor

std::vector<Support> supportsOnTheBack(const Surface& preop, const TetrahedralMesh& mesh) {
  const SupportSites sites = findSupportSites(preop, mesh, boundaryFaces(mesh));
  return {{.name = "vena cava", .kind = SupportKind::Fixed, .faces = sites.venaCava},
          {.name = "posterior bed", .kind = SupportKind::Sliding, .faces = sites.posteriorBed}};
}

/// Nodes drawn to the scan, in the order in which the scan was seen to touch them, and what a force on each
/// does.
class DrawnNodes {
 public:
  explicit DrawnNodes(const IncrementalModel& model)
      : model_(model), places_(-Eigen::VectorXi::Ones(static_cast<Index>(model.freeNodes().size()))) {}

  void add(std::vector<int> nodes) {
    std::erase_if(nodes, [&](int n) { return places_[n] >= 0; });
    if (nodes.empty()) return;
    for (const int n : nodes) {
      places_[n] = static_cast<int>(nodes_.size());
      nodes_.push_back(n);
    }
    const Eigen::MatrixXd more = model_.underForces(nodes);
    Eigen::MatrixXd all(more.rows(), fields_.cols() + more.cols());
    all << fields_, more;
    fields_ = std::move(all);
    const auto count = static_cast<Index>(nodes_.size());
    wanted_.conservativeResizeLike(VectorXd::Zero(count));
    compliance_.resize(count, count);
    for (Index i = 0; i < count; ++i) {
      const int node = nodes_[static_cast<std::size_t>(i)];
      const Index row = 3 * static_cast<Index>(model_.freeNodes()[static_cast<std::size_t>(node)]);
      compliance_.row(i) = model_.freeNormals().row(node) * fields_.middleRows<3>(row);
    }
    factor_ = (compliance_ + compliance_.transpose()) / 2;
    // Neighbours answer nearly alike: a part in a million keeps the factor sound.
    factor_.diagonal() *= 1 + 1e-6;
    if (!choleskyInPlace(factor_))
      throw std::runtime_error("the compliance of the nodes drawn to the scan is not positive definite");
  }

  /// Displacement of free node `n` along its normal, wanted in all.
  double& wanted(int n) { return wanted_[places_[n]]; }

  /// N x 3: the liver with every drawn node where it is wanted.
  [[nodiscard]] Points displacements() const {
    Eigen::MatrixXd forces = wanted_;
    solveCholesky(factor_, forces);
    const VectorXd field = fields_ * forces.col(0);
    return Eigen::Map<const Points>(field.data(), field.size() / 3, 3);
  }

 private:
  const IncrementalModel& model_;
  Eigen::VectorXi places_;  ///< of each free node among the drawn ones, or -1
  std::vector<int> nodes_;
  Eigen::MatrixXd fields_, compliance_, factor_;
  VectorXd wanted_;
};

}  // namespace

IncrementalModel::IncrementalModel(const Surface& preop, const TetrahedralMesh& mesh,
                                   const Progress& progress)
    : IncrementalModel(preop, mesh, supportsOnTheBack(preop, mesh), progress) {}

IncrementalModel::IncrementalModel(const Surface& preop, const TetrahedralMesh& mesh,
                                   std::vector<Support> supports, const Progress& progress)
    : preop_(preop), mesh_(mesh), rigid_(std::make_shared<const PreparedPreop>(preop)) {
  constexpr double kFineEdgeMm = 2.5;
  fine_ = subdividedTo(preop, kFineEdgeMm);
  places_ = MeshPlaces(mesh, fine_.points);
  const BoundaryFaces faces = boundaryFaces(mesh);
  const NodeNormals normals = nodeNormals(faces, mesh.nodes());
  std::vector<NodeConstraint> constraints = nodeConstraints(faces, normals, supports);
  checkHeld(mesh, constraints, faces, supports);
  std::vector<char> held(static_cast<std::size_t>(mesh.nodes()), 0);
  for (const NodeConstraint& constraint : constraints) held[static_cast<std::size_t>(constraint.node)] = 1;
  for (const int node : boundarySurface(mesh, faces).nodes)
    if (!held[static_cast<std::size_t>(node)]) freeNodes_.push_back(node);
  freeNormals_ = normals.normals(freeNodes_, Eigen::all);
  solver_ = std::make_shared<const ConstrainedStiffness>(assembleStiffness(mesh, {Material{}}),
                                                         std::move(constraints), progress);
}

Eigen::MatrixXd IncrementalModel::underForces(const std::vector<int>& drawn) const {
  Eigen::MatrixXd fields(3 * mesh_.nodes(), static_cast<Index>(drawn.size()));
  for (std::size_t first = 0; first < drawn.size(); first += kTogether) {
    const std::size_t count = std::min(kTogether, drawn.size() - first);
    std::vector<Points> forces(count, Points::Zero(mesh_.nodes(), 3));
    for (std::size_t k = 0; k < count; ++k) {
      const int n = drawn[first + k];
      forces[k].row(freeNodes_[static_cast<std::size_t>(n)]) = freeNormals_.row(n);
    }
    const std::vector<Points> solved = solver_->solve(forces, std::vector<double>(count, 1.0));
    for (std::size_t k = 0; k < count; ++k)
      fields.col(static_cast<Index>(first + k)) =
          Eigen::Map<const VectorXd>(solved[k].data(), solved[k].size());
  }
  return fields;
}

namespace {

/// Pre-op from scan. In the pre-op frame, so that the search does not depend on how the scanner stood.
Isometry3d undeformedPart(const IncrementalModel& model, const Surface& scan, const Isometry3d& preopFromScan,
                          const Progress& progress) {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Dirr;
  return registerDirr(model.rigid(), transformed(scan, preopFromScan, model.preop().frame), settings,
                      Isometry3d::Identity(), progress)
             .preopFromScan *
         preopFromScan;
}

/// Sums of the points' distances along the normal of the free node nearest to where each meets the surface.
struct Draw {
  std::vector<int> nodes;  ///< that have points, ascending
  VectorXd sums, counts;   ///< of every free node
  double meanMm = 0;       ///< of the distances' sizes
};

Draw drawOf(const IncrementalModel& model, const KdTree& nodes, const std::vector<Counterpart>& matches,
            const Points& posed, const Points& now) {
  const auto count = static_cast<Index>(model.freeNodes().size());
  Draw draw{{}, VectorXd::Zero(count), VectorXd::Zero(count)};
  const Points rest = placesOf(matches, model.fine().points), places = placesOf(matches, now);
  for (Index j = 0; j < posed.rows(); ++j) {
    const int node = nodes.nearest(rest.row(j).transpose()).index;
    const double along = model.freeNormals().row(node).dot(posed.row(j) - places.row(j));
    draw.sums[node] += along;
    draw.counts[node] += 1;
    draw.meanMm += std::abs(along) / static_cast<double>(posed.rows());
  }
  for (Index n = 0; n < count; ++n)
    if (draw.counts[n] > 0) draw.nodes.push_back(static_cast<int>(n));
  return draw;
}

UpdateResult increments(const IncrementalModel& model, const Surface& scan,
                        const Isometry3d& scanFromPreopStart, const IncrementalPlan& plan,
                        const UpdateSettings& settings, std::uint64_t seed, const Progress& progress) {
  UpdateResult result;
  const ScanChoice chosen = chooseScanPoints(scan, settings.samplePoints, seed);
  Isometry3d pose = scanFromPreopStart.inverse();
  if (plan.identifyUndeformed) pose = undeformedPart(model, scan, pose, progress.part(0, 0.2));
  const Points posed = transformed(chosen.points, pose);
  CounterpartSearch search(model.fine(), true);
  DrawnNodes drawn(model);
  const KdTree nodes(Points(model.mesh().points(model.freeNodes(), Eigen::all)));
  result.displacements = Points::Zero(model.mesh().nodes(), 3);
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= plan.maxIncrements; ++i) {
    progress.report(0.2 + 0.8 * i / plan.maxIncrements, "Drawing the surface to the scan");
    const Draw draw = drawOf(model, nodes, search.find(posed, chosen.labels), posed, search.points());
    result.iterations = i;
    if (std::abs(previous - draw.meanMm) < plan.settledMm) {
      result.converged = true;
      break;
    }
    previous = draw.meanMm;
    drawn.add(draw.nodes);
    for (const int n : draw.nodes) drawn.wanted(n) += plan.share * draw.sums[n] / draw.counts[n];
    result.displacements = drawn.displacements();
    search.moveTo(model.fine().points + Points(model.places().interpolate(result.displacements)));
  }
  result.stopReason = result.converged ? "increments no longer bring the surface nearer"
                                       : "the largest number of increments was reached";
  const Points places = placesOf(search.find(posed, chosen.labels), search.points());
  result.rmsMm = std::sqrt((places - posed).squaredNorm() / static_cast<double>(posed.rows()));
  result.scanFromPreop = pose.inverse();
  describeDeformation(model.mesh(), result);
  return result;
}

}  // namespace

UpdateResult updateIncrementally(const IncrementalModel& model, const Surface& scan,
                                 const Isometry3d& scanFromPreopStart, const IncrementalPlan& plan,
                                 const UpdateSettings& settings, std::uint64_t seed,
                                 const Progress& progress) {
  return timedUpdate(
      settings, [&] { return increments(model, scan, scanFromPreopStart, plan, settings, seed, progress); });
}

}  // namespace falciform
