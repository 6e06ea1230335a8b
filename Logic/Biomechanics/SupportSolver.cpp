#include "Logic/Biomechanics/SupportSolver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

/// Three nodes far apart that no candidate touches, with six directions that are statically determinate: all
/// of the first, two across the line to the second, one across the plane with the third.
std::vector<NodeConstraint> pins(const TetrahedralMesh& mesh, const std::vector<char>& taken) {
  const auto farthest = [&](const auto& distance) {
    Index best = -1;
    for (Index n = 0; n < mesh.nodes(); ++n)
      if (taken[static_cast<std::size_t>(n)] == 0 && (best < 0 || distance(n) > distance(best))) best = n;
    if (best < 0) throw InputError("every node is a candidate support; leave some of the liver free");
    return best;
  };
  const auto at = [&](Index n) { return Vector3d(mesh.points.row(n).transpose()); };
  const Vector3d centre = mesh.points.colwise().mean().transpose();
  const Index a = farthest([&](Index n) { return (at(n) - centre).norm(); });
  const Index b = farthest([&](Index n) { return (at(n) - at(a)).norm(); });
  const Vector3d line = (at(b) - at(a)).normalized();
  const Index c = farthest([&](Index n) { return (at(n) - at(a)).cross(line).norm(); });
  const Vector3d normal = (at(c) - at(a)).cross(line).normalized();
  Matrix3d acrossLine;
  acrossLine << normal.transpose(), line.cross(normal).transpose(), line.transpose();
  std::vector<NodeConstraint> result{
      {.node = static_cast<int>(a), .count = 3},
      {.node = static_cast<int>(b), .count = 2, .frame = acrossLine, .valuesMm = Vector3d::Zero()},
      {.node = static_cast<int>(c), .count = 1, .frame = frameAlong(normal), .valuesMm = Vector3d::Zero()}};
  return result;
}

}  // namespace

struct SupportSolver::State {
  Points nodes;
  BoundaryFaces faces;
  NodeNormals normals;
  std::optional<ReducedStiffness> reduced;
  Index candidates = 0;
  std::vector<int> candidateOf;  ///< 3 node + axis -> number among the candidates, or -1
  std::vector<std::int64_t> order;
  Eigen::MatrixXd compliance;              ///< candidates x candidates, mm/N
  std::array<Points, 3> weighed;           ///< K+ f of a unit acceleration along each axis, mm by m/s2
  Eigen::Matrix<double, 6, 3> rigidLoads;  ///< R' f of the same
  Eigen::Matrix<double, Eigen::Dynamic, 6> motions;
  std::optional<BackSubstitution> inner;

  void chooseCandidates(const CandidateSupports& where, std::vector<NodeConstraint>& frames,
                        std::vector<char>& full) const;
  void factorise(const TetrahedralMesh& mesh, const StiffnessMatrix& stiffness,
                 const std::vector<Material>& materials, const std::vector<char>& last,
                 const Progress& progress);
  void takeCompliance(const SupernodalView& factor);
  [[nodiscard]] Eigen::VectorXd candidateForces(const SupportHypothesis& hypothesis,
                                                Eigen::Matrix<double, 6, 1>& rigid) const;
};

/// Frames of the candidate nodes; `full` says of each node whether all three directions are candidates.
void SupportSolver::State::chooseCandidates(const CandidateSupports& where,
                                            std::vector<NodeConstraint>& frames,
                                            std::vector<char>& full) const {
  std::set<int> touched;
  const auto touch = [&](const std::vector<int>& list, bool wholly) {
    for (const int face : list) {
      if (face < 0 || face >= faces.size())
        throw InputError("candidate supports name boundary face " + std::to_string(face) +
                         " but the mesh has " + std::to_string(faces.size()) + " (from 0)");
      for (int k = 0; k < faces.nodesPerFace(); ++k) {
        const int node = faces.nodes(face, k);
        touched.insert(node);
        if (wholly || normals.sharp[static_cast<std::size_t>(node)] != 0)
          full[static_cast<std::size_t>(node)] = 1;
      }
    }
  };
  touch(where.sliding, false);
  touch(where.fixed, true);
  for (const int node : touched)
    frames.push_back({.node = node,
                      .count = 0,
                      .frame = frameAlong(normals.normals.row(node).transpose()),
                      .valuesMm = Vector3d::Zero()});
}

SupportSolver::SupportSolver(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                             const CandidateSupports& candidates, const Progress& progress) {
  const auto state = std::make_shared<State>();
  const StiffnessMatrix stiffness = assembleStiffness(mesh, materials, progress.part(0, 0.1));
  state->nodes = mesh.points;
  state->faces = boundaryFaces(mesh);
  state->normals = nodeNormals(state->faces, mesh.nodes());
  std::vector<NodeConstraint> frames;
  std::vector<char> full(static_cast<std::size_t>(mesh.nodes()), 0), taken = full;
  state->chooseCandidates(candidates, frames, full);
  if (frames.empty())
    throw InputError("there is no candidate support; name faces that may be held or pushed");
  for (const NodeConstraint& frame : frames) taken[static_cast<std::size_t>(frame.node)] = 1;
  for (const NodeConstraint& pin : pins(mesh, taken)) frames.push_back(pin);
  std::sort(frames.begin(), frames.end(),
            [](const NodeConstraint& a, const NodeConstraint& b) { return a.node < b.node; });
  state->reduced.emplace(stiffness, frames);
  std::vector<char> last;
  for (const std::int64_t direction : state->reduced->directions()) {
    const auto node = static_cast<std::size_t>(direction / 3);
    last.push_back(taken[node] != 0 && (direction % 3 == 0 || full[node] != 0));
  }
  state->factorise(mesh, stiffness, materials, last, progress.part(0.1, 1));
  state_ = state;
}

void SupportSolver::State::factorise(const TetrahedralMesh& mesh, const StiffnessMatrix& stiffness,
                                     const std::vector<Material>& materials, const std::vector<char>& last,
                                     const Progress& progress) {
  candidates = std::count(last.begin(), last.end(), 1);
  order = reduced->order(stiffness.graph, last);
  // Zeros that chain the candidates behind the rest, so that the factor's own reordering leaves them at the
  // end.
  std::vector<std::pair<std::int64_t, std::int64_t>> chain;
  for (std::size_t k = order.size() - static_cast<std::size_t>(candidates); k < order.size(); ++k)
    if (k > 0) chain.emplace_back(std::max(order[k], order[k - 1]), std::min(order[k], order[k - 1]));
  const SparseCholesky factor(withPlaces(reduced->matrix(), std::move(chain)), order, progress.part(0, 0.8));
  motions = rigidMotions(mesh.points);
  Eigen::MatrixXd loads(static_cast<Index>(order.size()), 3);
  for (int axis = 0; axis < 3; ++axis) {
    const Points forces = weightForces(mesh, materials, Vector3d::Unit(axis));
    reduced->gather(forces, loads.col(axis));
    rigidLoads.col(axis) = motions.transpose() * Eigen::Map<const VectorXd>(forces.data(), forces.size());
  }
  factor.solve(loads);
  for (int axis = 0; axis < 3; ++axis)
    weighed[static_cast<std::size_t>(axis)] = reduced->scatter(loads.col(axis));
  progress.report(0.85, "Compliance of the supports");
  takeCompliance(factor.supernodes());
  inner.emplace(factor.supernodes(), candidates);
  progress.report(1);
}

void SupportSolver::State::takeCompliance(const SupernodalView& factor) {
  order.assign(factor.order.begin(), factor.order.end());
  const std::int64_t inside = static_cast<std::int64_t>(order.size()) - candidates;
  candidateOf.assign(static_cast<std::size_t>(3 * nodes.rows()), -1);
  for (Index c = 0; c < candidates; ++c)
    candidateOf[static_cast<std::size_t>(
        reduced->directions()[static_cast<std::size_t>(order[static_cast<std::size_t>(inside + c)])])] =
        static_cast<int>(c);
  compliance = Eigen::MatrixXd::Zero(candidates, candidates);
  for (std::size_t s = 0; s + 1 < factor.super.size(); ++s) {
    const std::int64_t first = factor.super[s], height = factor.rowsBegin[s + 1] - factor.rowsBegin[s];
    for (std::int64_t column = std::max(first, inside); column < factor.super[s + 1]; ++column)
      for (std::int64_t r = column - first; r < height; ++r)
        compliance(factor.rows[static_cast<std::size_t>(factor.rowsBegin[s] + r)] - inside, column - inside) =
            factor.values[factor.valuesBegin[s] + (column - first) * height + r];
  }
  invertCholesky(compliance);
}

/// The forces lambda of a hypothesis as loads of the candidate directions, -B' lambda, and the rigid motion
/// a.
Eigen::VectorXd SupportSolver::State::candidateForces(const SupportHypothesis& hypothesis,
                                                      Eigen::Matrix<double, 6, 1>& rigid) const {
  const std::vector<NodeConstraint> constraints = nodeConstraints(faces, normals, hypothesis.supports);
  checkHeld(nodes, constraints, faces, hypothesis.supports);
  // Each row of B: up to three candidate directions of one node, with weights.
  struct Row {
    std::array<int, 3> candidate{-1, -1, -1};
    Vector3d weight = Vector3d::Zero();
  };
  std::vector<Row> rows;
  std::vector<double> values;
  std::vector<Eigen::Matrix<double, 1, 6>> heldRows;
  const Vector3d& g = hypothesis.gravityChangeMPerS2;
  for (const NodeConstraint& constraint : constraints) {
    const Matrix3d* frame = reduced->frameOf(constraint.node);
    for (int k = 0; k < constraint.count; ++k) {
      const Vector3d axis = constraint.frame.row(k).transpose();
      Row row;
      row.weight = (frame == nullptr ? Matrix3d(Matrix3d::Identity()) : *frame) * axis;
      for (int d = 0; d < 3; ++d) {
        row.candidate[static_cast<std::size_t>(d)] =
            candidateOf[static_cast<std::size_t>(3 * constraint.node + d)];
        if (row.candidate[static_cast<std::size_t>(d)] >= 0) continue;
        if (std::abs(row.weight[d]) > 1e-6)
          throw InputError("a support holds node " + std::to_string(constraint.node) +
                           " in a direction that is no candidate; widen the candidate supports");
        row.weight[d] = 0;
      }
      rows.push_back(row);
      const Vector3d free = g[0] * weighed[0].row(constraint.node).transpose() +
                            g[1] * weighed[1].row(constraint.node).transpose() +
                            g[2] * weighed[2].row(constraint.node).transpose();
      values.push_back(axis.dot(free) - constraint.valuesMm[k]);
      heldRows.push_back(axis.transpose() * motions.middleRows<3>(3 * constraint.node));
    }
  }
  const auto count = static_cast<Index>(rows.size());
  Eigen::MatrixXd right(count, 7);  // r, and the six columns of BR
  for (Index r = 0; r < count; ++r) {
    right(r, 0) = values[static_cast<std::size_t>(r)];
    right.row(r).tail<6>() = heldRows[static_cast<std::size_t>(r)];
  }
  const Eigen::MatrixXd held6 = right.rightCols<6>();
  Eigen::MatrixXd system(count, count);
  for (Index c = 0; c < count; ++c)
    for (Index r = c; r < count; ++r) {
      double sum = 0;
      const Row &a = rows[static_cast<std::size_t>(r)], &b = rows[static_cast<std::size_t>(c)];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          if (a.weight[static_cast<Index>(i)] != 0 && b.weight[static_cast<Index>(j)] != 0)
            sum += a.weight[static_cast<Index>(i)] * b.weight[static_cast<Index>(j)] *
                   compliance(a.candidate[i], b.candidate[j]);
      system(r, c) = sum;
    }
  keepBlasSingleThreaded();
  if (!choleskyInPlace(system))
    throw InputError("the supports contradict each other or repeat; name each region once");
  solveCholesky(system, right);
  const Eigen::Matrix<double, 6, 6> reduced6 = held6.transpose() * right.rightCols<6>();
  rigid = reduced6.ldlt().solve(rigidLoads * g - held6.transpose() * right.col(0));
  const Eigen::VectorXd lambda = right.col(0) + right.rightCols<6>() * rigid;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(candidates);
  for (Index r = 0; r < count; ++r)
    for (std::size_t i = 0; i < 3; ++i)
      if (rows[static_cast<std::size_t>(r)].candidate[i] >= 0)
        forces[rows[static_cast<std::size_t>(r)].candidate[i]] -=
            rows[static_cast<std::size_t>(r)].weight[static_cast<Index>(i)] * lambda[r];
  return forces;
}

std::vector<Points> SupportSolver::solve(const std::vector<SupportHypothesis>& hypotheses) const {
  const State& s = *state_;
  const auto count = static_cast<Index>(hypotheses.size());
  const Index inside = static_cast<Index>(s.order.size()) - s.candidates;
  Eigen::MatrixXd forces(s.candidates, count);
  Eigen::Matrix<double, 6, Eigen::Dynamic> rigid(6, count);
  for (Index h = 0; h < count; ++h) {
    Eigen::Matrix<double, 6, 1> motion;
    forces.col(h) = s.candidateForces(hypotheses[static_cast<std::size_t>(h)], motion);
    rigid.col(h) = motion;
  }
  const Eigen::MatrixXd moved = product(s.compliance, forces);
  Eigen::MatrixXf values(static_cast<Index>(s.order.size()), count);
  values.bottomRows(s.candidates) = moved.cast<float>();
  s.inner->solve(values);
  std::vector<Points> result;
  VectorXd variables(static_cast<Index>(s.order.size()));
  for (Index h = 0; h < count; ++h) {
    for (Index k = 0; k < variables.size(); ++k)
      variables[s.order[static_cast<std::size_t>(k)]] = k < inside ? values(k, h) : moved(k - inside, h);
    Points u = s.reduced->scatter(variables);
    Eigen::Map<VectorXd>(u.data(), u.size()) += s.motions * rigid.col(h);
    const Vector3d& g = hypotheses[static_cast<std::size_t>(h)].gravityChangeMPerS2;
    for (int axis = 0; axis < 3; ++axis)
      if (g[axis] != 0) u += g[axis] * s.weighed[static_cast<std::size_t>(axis)];
    result.push_back(std::move(u));
  }
  return result;
}

Points SupportSolver::solve(const SupportHypothesis& hypothesis) const {
  return std::move(solve(std::vector<SupportHypothesis>{hypothesis}).front());
}

const BoundaryFaces& SupportSolver::faces() const { return state_->faces; }
const NodeNormals& SupportSolver::normals() const { return state_->normals; }
Index SupportSolver::candidateDirections() const { return state_->candidates; }

}  // namespace falciform
