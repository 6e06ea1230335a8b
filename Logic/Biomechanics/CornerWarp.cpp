#include "Logic/Biomechanics/CornerWarp.h"

#include "Logic/Biomechanics/CorotationalWarp.h"
#include "Logic/Biomechanics/ReferenceTetrahedron.h"

namespace falciform {

struct CornerWarp::State {
  TetrahedralMesh linear;                              ///< of the corners alone
  std::vector<Eigen::Matrix<double, 4, 3>> gradients;  ///< of each element's barycentric coordinates
  VectorXd volumes;                                    ///< of the elements
  std::vector<int> cornerOf;                           ///< of each node of the mesh, -1 at edge nodes
  std::vector<std::array<int, 3>> edges;               ///< edge node and the two corners it lies between
  std::unique_ptr<CorotationalWarp> warp;
};

CornerWarp::CornerWarp(const TetrahedralMesh& mesh) {
  checkMesh(mesh, "the mesh");
  const auto state = std::make_shared<State>();
  state->cornerOf.assign(static_cast<std::size_t>(mesh.nodes()), -1);
  for (Index e = 0; e < mesh.size(); ++e)
    for (int k = 0; k < 4; ++k) state->cornerOf[static_cast<std::size_t>(mesh.elements(e, k))] = 0;
  for (std::size_t n = 0; n < state->cornerOf.size(); ++n)
    if (state->cornerOf[n] == 0) {
      state->cornerOf[n] = static_cast<int>(corners_.size());
      corners_.push_back(static_cast<int>(n));
    }
  TetrahedralMesh& linear = state->linear;
  linear.points = mesh.points(corners_, Eigen::all);
  linear.elements.resize(mesh.size(), 4);
  state->volumes.resize(mesh.size());
  std::vector<char> known(state->cornerOf.size(), 0);
  for (Index e = 0; e < mesh.size(); ++e) {
    for (int k = 0; k < 4; ++k)
      linear.elements(e, k) = state->cornerOf[static_cast<std::size_t>(mesh.elements(e, k))];
    state->gradients.push_back(barycentricGradients(mesh, e));
    state->volumes[e] = cornerVolume(mesh, e);
    if (!mesh.quadratic()) continue;
    for (int k = 4; k < 10; ++k) {
      const int node = mesh.elements(e, k);
      if (known[static_cast<std::size_t>(node)] != 0) continue;
      known[static_cast<std::size_t>(node)] = 1;
      const auto& ends = kTetrahedronEdges[static_cast<std::size_t>(k - 4)];
      state->edges.push_back({node, mesh.elements(e, ends[0]), mesh.elements(e, ends[1])});
    }
  }
  state->warp = std::make_unique<CorotationalWarp>(linear, std::vector<int>{});
  state_ = state;
}

CornerWarp::Change CornerWarp::apply(const Points& linear) const {
  const State& s = *state_;
  const Points given = linear(corners_, Eigen::all);
  const Points added = s.warp->apply(given) - given;
  Points turns = Points::Zero(given.rows(), 3);
  VectorXd volumes = VectorXd::Zero(given.rows());
  for (Index e = 0; e < s.linear.size(); ++e) {
    Matrix3d gradient = Matrix3d::Zero();
    for (int k = 0; k < 4; ++k)
      gradient.noalias() +=
          given.row(s.linear.elements(e, k)).transpose() * s.gradients[static_cast<std::size_t>(e)].row(k);
    const Eigen::RowVector3d turn =
        Eigen::RowVector3d(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                           gradient(1, 0) - gradient(0, 1)) /
        2;
    for (int k = 0; k < 4; ++k) {
      turns.row(s.linear.elements(e, k)) += s.volumes[e] * turn;
      volumes[s.linear.elements(e, k)] += s.volumes[e];
    }
  }
  turns.array().colwise() /= volumes.array();
  Change change{Points(linear.rows(), 3), Points(linear.rows(), 3)};
  change.added(corners_, Eigen::all) = added;
  change.turns(corners_, Eigen::all) = turns;
  for (const auto& [node, a, b] : s.edges) {
    change.added.row(node) = (change.added.row(a) + change.added.row(b)) / 2;
    change.turns.row(node) = (change.turns.row(a) + change.turns.row(b)) / 2;
  }
  return change;
}

}  // namespace falciform
