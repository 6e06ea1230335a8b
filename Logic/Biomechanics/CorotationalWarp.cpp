#include "Logic/Biomechanics/CorotationalWarp.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Biomechanics/SparseCholesky.h"
#include "Logic/Biomechanics/StiffnessMatrix.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 512;

/// exp(w) (I + e) for du/dx = w + e, w skew and e symmetric.
Matrix3d turnedGradient(const Matrix3d& gradient) {
  const Matrix3d strain = (gradient + gradient.transpose()) / 2;
  const Vector3d turn = Vector3d(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                                 gradient(1, 0) - gradient(0, 1)) /
                        2;
  return rotationOf(turn) * (Matrix3d::Identity() + strain);
}

}  // namespace

struct CorotationalWarp::State {
  TetrahedralMesh mesh;
  std::vector<int> anchors;
  std::vector<int> variable;  ///< of each node, -1 if anchored
  bool anchored = false;      ///< by the caller
  SparseLower laplacian;      ///< all nodes
  std::optional<SparseCholesky> factor;

  void assemble();
  [[nodiscard]] SparseLower reduced() const;
  [[nodiscard]] Points forces(const Points& displacements) const;
};

void CorotationalWarp::State::assemble() {
  const NodeGraph graph = nodeGraph(mesh);
  const auto& places = quadraturePlaces(mesh.quadratic());
  const int nodes = static_cast<int>(mesh.elements.cols());
  laplacian.begin.push_back(0);
  for (std::size_t i = 0; i + 1 < graph.begin.size(); ++i) {
    for (std::size_t at = graph.begin[i]; at < graph.begin[i + 1]; ++at)
      if (graph.neighbours[at] >= static_cast<int>(i)) laplacian.rows.push_back(graph.neighbours[at]);
    laplacian.begin.push_back(static_cast<std::int64_t>(laplacian.rows.size()));
  }
  laplacian.values.assign(laplacian.rows.size(), 0);
  for (Index e = 0; e < mesh.size(); ++e) {
    const auto gradients = barycentricGradients(mesh, e);
    const double weight = cornerVolume(mesh, e) / static_cast<double>(places.size());
    Eigen::Matrix<double, 10, 10> local = Eigen::Matrix<double, 10, 10>::Zero();
    for (const Eigen::Vector4d& place : places) {
      const auto shape = shapeGradients(place, gradients, nodes);
      local.topLeftCorner(nodes, nodes).noalias() += weight * shape * shape.transpose();
    }
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < nodes; ++b) {
        const int column = mesh.elements(e, a), row = mesh.elements(e, b);
        if (row < column) continue;
        const auto from = laplacian.rows.begin() + laplacian.begin[static_cast<std::size_t>(column)];
        const auto to = laplacian.rows.begin() + laplacian.begin[static_cast<std::size_t>(column) + 1];
        laplacian
            .values[static_cast<std::size_t>(std::lower_bound(from, to, row) - laplacian.rows.begin())] +=
            local(a, b);
      }
  }
  std::vector<char> kept(static_cast<std::size_t>(mesh.nodes()), 1);
  for (const int anchor : anchors) kept[static_cast<std::size_t>(anchor)] = 0;
  variable.assign(kept.size(), -1);
  int count = 0;
  for (std::size_t n = 0; n < kept.size(); ++n)
    if (kept[n] != 0) variable[n] = count++;
  std::vector<std::int64_t> order;
  for (const int node : nestedDissection(graph, kept))
    order.push_back(variable[static_cast<std::size_t>(node)]);
  factor.emplace(reduced(), order);
}

SparseLower CorotationalWarp::State::reduced() const {
  SparseLower result{.begin = {0}, .rows = {}, .values = {}};
  for (std::size_t column = 0; column < variable.size(); ++column) {
    if (variable[column] < 0) continue;
    for (auto at = static_cast<std::size_t>(laplacian.begin[column]);
         at < static_cast<std::size_t>(laplacian.begin[column + 1]); ++at) {
      const int row = variable[static_cast<std::size_t>(laplacian.rows[at])];
      if (row < 0) continue;
      result.rows.push_back(row);
      result.values.push_back(laplacian.values[at]);
    }
    result.begin.push_back(static_cast<std::int64_t>(result.rows.size()));
  }
  return result;
}

/// The integrals of (F - I) grad N_i: what the Laplacian of the sought displacements must equal.
Points CorotationalWarp::State::forces(const Points& displacements) const {
  const auto& places = quadraturePlaces(mesh.quadratic());
  const int nodes = static_cast<int>(mesh.elements.cols());
  std::vector<Eigen::Matrix<double, 10, 3>> shares(static_cast<std::size_t>(mesh.size()));
  forEachChunk(shares.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e) {
      const auto element = static_cast<Index>(e);
      const auto gradients = barycentricGradients(mesh, element);
      const double weight = cornerVolume(mesh, element) / static_cast<double>(places.size());
      Eigen::Matrix<double, 10, 3>& share = shares[e];
      share.setZero();
      for (const Eigen::Vector4d& place : places) {
        const auto shape = shapeGradients(place, gradients, nodes);
        Matrix3d gradient = Matrix3d::Zero();
        for (int k = 0; k < nodes; ++k)
          gradient.noalias() += displacements.row(mesh.elements(element, k)).transpose() * shape.row(k);
        const Matrix3d wanted = turnedGradient(gradient) - Matrix3d::Identity();
        for (int k = 0; k < nodes; ++k)
          share.row(k).noalias() += weight * (wanted * shape.row(k).transpose()).transpose();
      }
    }
  });
  Points result = Points::Zero(mesh.nodes(), 3);
  for (Index e = 0; e < mesh.size(); ++e)
    for (int k = 0; k < nodes; ++k)
      result.row(mesh.elements(e, k)) += shares[static_cast<std::size_t>(e)].row(k);
  return result;
}

CorotationalWarp::CorotationalWarp(const TetrahedralMesh& mesh, const std::vector<int>& anchors,
                                   const Progress& progress) {
  checkMesh(mesh, "the mesh");
  progress.report(0, "Preparing for large turns");
  const auto state = std::make_shared<State>();
  state->mesh = mesh;
  state->anchors = anchors;
  std::sort(state->anchors.begin(), state->anchors.end());
  state->anchors.erase(std::unique(state->anchors.begin(), state->anchors.end()), state->anchors.end());
  for (const int anchor : state->anchors)
    if (anchor < 0 || anchor >= mesh.nodes())
      throw InputError("anchor node " + std::to_string(anchor) + " is not among the mesh's " +
                       std::to_string(mesh.nodes()) + " nodes (from 0)");
  state->anchored = !state->anchors.empty();
  if (!state->anchored) state->anchors.push_back(mesh.elements(0, 0));
  state->assemble();
  state_ = state;
  progress.report(1);
}

Points CorotationalWarp::apply(const Points& displacements) const {
  const State& s = *state_;
  if (displacements.rows() != s.mesh.nodes())
    throw InputError("there are " + std::to_string(displacements.rows()) + " displacements for a mesh of " +
                     std::to_string(s.mesh.nodes()) + " nodes");
  Points right = s.forces(displacements);
  // Anchors keep what they were given: their part of the matrix goes to the right-hand side.
  for (std::size_t column = 0; column < s.variable.size(); ++column)
    for (auto at = static_cast<std::size_t>(s.laplacian.begin[column]);
         at < static_cast<std::size_t>(s.laplacian.begin[column + 1]); ++at) {
      const auto row = static_cast<std::size_t>(s.laplacian.rows[at]);
      const double value = s.laplacian.values[at];
      if (s.variable[column] >= 0 && s.variable[row] < 0)
        right.row(static_cast<Index>(column)) -= value * displacements.row(static_cast<Index>(row));
      if (s.variable[row] >= 0 && s.variable[column] < 0)
        right.row(static_cast<Index>(row)) -= value * displacements.row(static_cast<Index>(column));
    }
  Eigen::MatrixXd unknowns(s.mesh.nodes() - static_cast<Index>(s.anchors.size()), 3);
  for (std::size_t n = 0; n < s.variable.size(); ++n)
    if (s.variable[n] >= 0) unknowns.row(s.variable[n]) = right.row(static_cast<Index>(n));
  s.factor->solve(unknowns);
  Points result = displacements;
  for (std::size_t n = 0; n < s.variable.size(); ++n)
    if (s.variable[n] >= 0) result.row(static_cast<Index>(n)) = unknowns.row(s.variable[n]);
  if (!s.anchored) result.rowwise() += (displacements.colwise().mean() - result.colwise().mean()).eval();
  return result;
}

}  // namespace falciform
