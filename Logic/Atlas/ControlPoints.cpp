#include "Logic/Atlas/ControlPoints.h"

#include <algorithm>
#include <cmath>

#include "Logic/Atlas/MethodResult.h"
#include "Logic/Atlas/ScanChoice.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Biomechanics/StiffnessMatrix.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 128;

class ControlPointFit {
 public:
  ControlPointFit(const AtlasModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
                  const ControlPointPlan& plan, const UpdateSettings& settings, std::uint64_t seed)
      : model_(model),
        plan_(plan),
        pose_(scanFromPreopStart.inverse()),
        scan_(chooseScanPoints(scan, settings.samplePoints, seed)),
        search_(model.fine(), true),
        coefficients_(VectorXd::Zero(model.atlas().rank())) {
    const Material tissue = materialsOf(model.atlas().design).front();
    const double energyOfOne = tissue.youngsModulusMPa * model.atlas().nodeVolumesMm3.sum();
    penalty_ = model.atlas().stiffness * (plan.energyWeightMm2 / (2 * energyOfOne));
  }

  UpdateResult run(const Progress& progress) {
    UpdateResult result;
    for (int i = 1; i <= plan_.maxIterations; ++i) {
      progress.report(static_cast<double>(i) / (plan_.maxIterations + 1), "Moving control points");
      const double change = step();
      result.iterations = i;
      if (change < plan_.settledMm) {
        result.converged = true;
        break;
      }
    }
    result.stopReason =
        result.converged ? "the fitted surface has settled" : "the largest number of iterations was reached";
    match();
    result.rmsMm = std::sqrt((placesOf(matches_, search_.points()) - posed_).squaredNorm() /
                             static_cast<double>(posed_.rows()));
    result.scanFromPreop = pose_.inverse();
    result.displacements = model_.displacements(coefficients_);
    result.coefficients = coefficients_;
    describeDeformation(model_.atlas().mesh, result);
    return result;
  }

 private:
  void match() {
    posed_ = transformed(scan_.points, pose_);
    matches_ = search_.find(posed_, scan_.labels);
  }

  /// Unit vectors along which scan point j is to meet the surface, as columns.
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic> directions(std::size_t j) const {
    if (search_.uses(scan_.labels[j])) return Matrix3d::Identity();
    const Points corners = search_.points()(matches_[j].vertices, Eigen::all);
    const Vector3d a = corners.row(0), b = corners.row(1), c = corners.row(2);
    const Vector3d normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 ? Vector3d(normal / length) : Vector3d(Vector3d::UnitZ());
  }

  /// One step of Gauss-Newton; returns the RMS change of the surface at the counterparts.
  double step() {
    match();
    const Index rank = coefficients_.size(), size = rank + 6;
    const Vector3d centre = posed_.colwise().mean().transpose();
    const Points rest = placesOf(matches_, model_.fine().points);
    const std::size_t chunks = (matches_.size() + kChunk - 1) / kChunk;
    std::vector<Eigen::MatrixXd> parts(chunks);
    forEachChunk(matches_.size(), kChunk, [&](std::size_t first, std::size_t last) {
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(size + 1, static_cast<Index>(3 * (last - first)));
      for (std::size_t j = first; j < last; ++j) {
        const auto row = static_cast<Index>(j);
        const auto along = directions(j);
        const Vector3d y = posed_.row(row).transpose();
        // The meeting: along . (x0 + U c) = along . (y + turn x (y - centre) + shift).
        auto own = rows.middleCols(static_cast<Index>(3 * (j - first)), along.cols());
        own.topRows(rank) = model_.modesAt(matches_[j]).transpose() * along;
        for (Index d = 0; d < along.cols(); ++d) {
          own.block<3, 1>(rank, d) = -(y - centre).cross(along.col(d));
          own.block<3, 1>(rank + 3, d) = -along.col(d);
          own(size, d) = along.col(d).dot(y - rest.row(row).transpose());
        }
      }
      parts[first / kChunk] = outerSquare(rows);
    });
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size + 1, size + 1);
    for (const Eigen::MatrixXd& part : parts) sum += part;
    sum /= static_cast<double>(matches_.size());
    Eigen::MatrixXd normal = sum.topLeftCorner(size, size);
    normal.topLeftCorner(rank, rank) += penalty_;
    normal.diagonal().array() += 1e-9;  // a turn that the scan does not tell
    return take(normal.ldlt().solve(sum.col(size).head(size)), centre);
  }

  double take(const VectorXd& solution, const Vector3d& centre) {
    const Index rank = coefficients_.size();
    const VectorXd change = solution.head(rank) - coefficients_;
    coefficients_ = solution.head(rank);
    const Vector3d turn = solution.segment<3>(rank), shift = solution.tail<3>();
    const Isometry3d motion = motionAbout(centre, turn, shift);
    pose_ = motion * pose_;
    const Points before = placesOf(matches_, search_.points()), scan = transformed(posed_, motion);
    search_.moveTo(model_.movedPoints(coefficients_));
    const Points after = placesOf(matches_, search_.points());
    return std::sqrt(((after - scan) - (before - posed_)).squaredNorm() / static_cast<double>(scan.rows()));
  }

  const AtlasModel& model_;
  const ControlPointPlan& plan_;
  Isometry3d pose_;  ///< pre-op from scan
  ScanChoice scan_;
  CounterpartSearch search_;
  VectorXd coefficients_;
  Eigen::MatrixXd penalty_;
  Points posed_;
  std::vector<Counterpart> matches_;
};

}  // namespace

std::shared_ptr<const Atlas> controlPointModes(const LoadResponses& loads) {
  auto atlas = std::make_shared<Atlas>();
  atlas->mesh = loads.mesh;
  atlas->nodeVolumesMm3 = nodalVolumes(loads.mesh);
  const Index nodes = loads.mesh.nodes();
  for (Index k = 0; k < loads.loads(); ++k) {
    const VectorXd field = loads.responses.row(k).transpose().cast<double>() / loads.rmsMm[k];
    atlas->modes.emplace_back(Eigen::Map<const Points>(field.data(), nodes, 3));
  }
  atlas->coefficients = Eigen::MatrixXd::Identity(loads.loads(), loads.loads());
  const StiffnessMatrix stiffness = assembleStiffness(loads.mesh, materialsOf(atlas->design));
  Eigen::MatrixXd fields(3 * nodes, loads.loads()), forces(3 * nodes, loads.loads());
  forEachChunk(atlas->modes.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Points force = stiffness.times(atlas->modes[k]);
      fields.col(static_cast<Index>(k)) =
          Eigen::Map<const VectorXd>(atlas->modes[k].data(), atlas->modes[k].size());
      forces.col(static_cast<Index>(k)) = Eigen::Map<const VectorXd>(force.data(), force.size());
    }
  });
  const Eigen::MatrixXd energy = transposedProduct(fields, forces);
  atlas->stiffness = (energy + energy.transpose()) / 2;
  return atlas;
}

std::shared_ptr<const Atlas> controlPointModes(const TetrahedralMesh& mesh, const ControlPointPlan& plan,
                                               const Progress& progress) {
  keepBlasSingleThreaded();
  return controlPointModes(solveSurfaceLoads(mesh, materialsOf(AtlasDesign{}),
                                             {.centres = plan.controlPoints, .radiusMm = plan.radiusMm},
                                             progress));
}

UpdateResult updateByControlPoints(const AtlasModel& model, const Surface& scan,
                                   const Isometry3d& scanFromPreopStart, const ControlPointPlan& plan,
                                   const UpdateSettings& settings, std::uint64_t seed,
                                   const Progress& progress) {
  return timedUpdate(settings, [&] {
    return ControlPointFit(model, scan, scanFromPreopStart, plan, settings, seed).run(progress);
  });
}

}  // namespace falciform
