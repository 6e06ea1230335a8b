#include "Logic/Atlas/SurfaceLoads.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr std::size_t kTogether = 48;  ///< loads solved in one pass over the factor

/// Farthest-point sampling, from the first on.
Points spread(const Points& places, int count) {
  if (count < 1 || count > places.rows())
    throw InputError("there are " + std::to_string(count) + " load centres for a surface of " +
                     std::to_string(places.rows()) + " faces; choose 1 up to that");
  Points chosen(count, 3);
  VectorXd nearest = VectorXd::Constant(places.rows(), INFINITY);
  Index next = 0;
  for (int c = 0; c < count; ++c) {
    chosen.row(c) = places.row(next);
    for (Index p = 0; p < places.rows(); ++p)
      nearest[p] = std::min(nearest[p], (places.row(p) - chosen.row(c)).squaredNorm());
    nearest.maxCoeff(&next);
  }
  return chosen;
}

/// Takes rigid motions out of fields, and resultants out of loads, by the mass of an even density.
class RigidPart {
 public:
  RigidPart(const Points& nodes, const VectorXd& volumes)
      : motions_(rigidMotions(nodes)), weights_(3 * nodes.rows()) {
    for (Index n = 0; n < nodes.rows(); ++n) weights_.segment<3>(3 * n).setConstant(volumes[n]);
    inverse_ = (motions_.transpose() * weights_.asDiagonal() * motions_).eval().inverse();
  }
  void balance(Points& load) const {
    Eigen::Map<VectorXd> f(load.data(), load.size());
    f -= weights_.cwiseProduct(motions_ * (inverse_ * (motions_.transpose() * f)));
  }
  void remove(Points& field) const {
    Eigen::Map<VectorXd> u(field.data(), field.size());
    u -= motions_ * (inverse_ * (motions_.transpose() * weights_.cwiseProduct(u)));
  }

 private:
  Eigen::Matrix<double, Eigen::Dynamic, 6> motions_;
  VectorXd weights_;
  Eigen::Matrix<double, 6, 6> inverse_;
};

/// Nodal forces of one load: its profile integrated with the face's shares.
Points loadOf(const TetrahedralMesh& mesh, const BoundaryFaces& faces, const Vector3d& centre, int axis,
              double radiusMm) {
  Points load = Points::Zero(mesh.nodes(), 3);
  for (Index f = 0; f < faces.size(); ++f)
    for (int k = 0; k < faces.nodesPerFace(); ++k) {
      const int node = faces.nodes(f, k);
      const double squared = (mesh.points.row(node).transpose() - centre).squaredNorm();
      load(node, axis) += std::exp(-squared / (2 * radiusMm * radiusMm)) * faces.areaVectors.row(f).norm() *
                          faceShare(faces.quadratic, k);
    }
  return load;
}

}  // namespace

LoadResponses solveSurfaceLoads(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                                const SurfaceLoadPlan& plan, const Progress& progress) {
  if (!(plan.radiusMm > 0))
    throw InputError("the loads' radius is " + std::to_string(plan.radiusMm) + " mm; give more than 0");
  StiffnessMatrix stiffness = assembleStiffness(mesh, materials, progress.part(0, 0.1));
  const BoundaryFaces faces = boundaryFaces(mesh);
  const VectorXd volumes = nodalVolumes(mesh);
  const RigidPart rigid(mesh.points, volumes);
  const ConstrainedStiffness solver(std::move(stiffness), determinatePins(mesh.points),
                                    progress.part(0.1, 0.5));

  LoadResponses result{
      .mesh = mesh, .centres = spread(faceCentres(mesh, faces), plan.centres), .responses = {}, .rmsMm = {}};
  const auto loads = static_cast<std::size_t>(3 * plan.centres);
  result.responses.resize(static_cast<Index>(loads), 3 * mesh.nodes());
  result.rmsMm.resize(static_cast<Index>(loads));
  for (std::size_t first = 0; first < loads; first += kTogether) {
    progress.report(0.5 + 0.5 * static_cast<double>(first) / static_cast<double>(loads),
                    "Solving for surface loads");
    const std::size_t count = std::min(kTogether, loads - first);
    std::vector<Points> forces(count);
    forEachChunk(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto load = static_cast<Index>(first + k);
        forces[k] = loadOf(mesh, faces, result.centres.row(load / 3).transpose(), static_cast<int>(load % 3),
                           plan.radiusMm);
        rigid.balance(forces[k]);
      }
    });
    std::vector<Points> fields = solver.solve(forces, std::vector<double>(count, 1.0));
    forEachChunk(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto load = static_cast<Index>(first + k);
        rigid.remove(fields[k]);
        result.responses.row(load) =
            Eigen::Map<const Eigen::RowVectorXd>(fields[k].data(), fields[k].size()).cast<float>();
        result.rmsMm[load] = std::sqrt(volumes.dot(fields[k].rowwise().squaredNorm()) / volumes.sum());
      }
    });
  }
  progress.report(1);
  return result;
}

}  // namespace falciform
