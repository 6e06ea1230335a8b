#include "Logic/Biomechanics/SupportSolver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Biomechanics/MeshPieces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"

namespace falciform {

struct SupportSolver::State {
  Points nodes;
  BoundaryFaces faces;
  NodeNormals normals;
  std::optional<ReducedStiffness> reduced;
  std::vector<Support> held;     ///< in every hypothesis
  std::vector<char> eliminated;  ///< of each node: its constraint is not the hypotheses' affair
  bool pinned = false;           ///< the rigid motions are pinned and must be found
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
  [[nodiscard]] std::vector<NodeConstraint> pins(const std::vector<char>& taken) const;
  void hold(const std::vector<Support>& always, const std::vector<char>& taken,
            std::vector<NodeConstraint>& frames);
  void factorise(const TetrahedralMesh& mesh, const StiffnessMatrix& stiffness,
                 const std::vector<Material>& materials, const std::vector<char>& last,
                 const Progress& progress);
  void takeCompliance(const SparseCholesky& factor);
  struct Row;
  [[nodiscard]] Row rowOf(int node, const Vector3d& axis) const;
  [[nodiscard]] double complianceOf(const Row& a, const Row& b) const;
  [[nodiscard]] Eigen::MatrixXd moved(const Eigen::MatrixXd& forces) const;
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
  for (const NodeConstraint& constraint : nodeConstraints(faces, normals, where.held))
    if (constraint.count > 1 && touched.contains(constraint.node))
      full[static_cast<std::size_t>(constraint.node)] = 1;
  for (const int node : touched)
    frames.push_back({.node = node,
                      .count = 0,
                      .frame = frameAlong(normals.normals.row(node).transpose()),
                      .valuesMm = Vector3d::Zero()});
}

/// Pins away from candidates and from what is held.
std::vector<NodeConstraint> SupportSolver::State::pins(const std::vector<char>& taken) const {
  std::vector<char> closed = eliminated;
  for (std::size_t n = 0; n < closed.size(); ++n) closed[n] |= taken[n];
  return determinatePins(nodes, closed);
}

/// Takes the supports that are held always: constraints of nodes that no candidate touches join `frames`.
void SupportSolver::State::hold(const std::vector<Support>& always, const std::vector<char>& taken,
                                std::vector<NodeConstraint>& frames) {
  for (const Support& support : always)
    if (support.kind != SupportKind::Fixed && support.kind != SupportKind::Sliding)
      throw InputError("the support '" + support.name +
                       "' moves or yields; supports held always are fixed or sliding");
  held = always;
  motions = rigidMotions(nodes);
  eliminated.assign(static_cast<std::size_t>(nodes.rows()), 0);
  std::vector<NodeConstraint> away;
  for (const NodeConstraint& constraint : nodeConstraints(faces, normals, always))
    if (taken[static_cast<std::size_t>(constraint.node)] == 0) {
      eliminated[static_cast<std::size_t>(constraint.node)] = 1;
      away.push_back(constraint);
    }
  pinned = !holds(motions, away);
  frames.insert(frames.end(), away.begin(), away.end());
}

SupportSolver::SupportSolver(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                             const CandidateSupports& candidates, const Progress& progress) {
  checkOnePiece(mesh);
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
  state->hold(candidates.held, taken, frames);
  if (state->pinned)
    for (const NodeConstraint& pin : state->pins(taken)) frames.push_back(pin);
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
  takeCompliance(factor);
  inner.emplace(factor, candidates);
  progress.report(1);
}

void SupportSolver::State::takeCompliance(const SparseCholesky& factor) {
  const SupernodalStructure& structure = factor.structure();
  order = structure.order;
  const std::int64_t inside = static_cast<std::int64_t>(order.size()) - candidates;
  candidateOf.assign(static_cast<std::size_t>(3 * nodes.rows()), -1);
  for (Index c = 0; c < candidates; ++c)
    candidateOf[static_cast<std::size_t>(
        reduced->directions()[static_cast<std::size_t>(order[static_cast<std::size_t>(inside + c)])])] =
        static_cast<int>(c);
  compliance = Eigen::MatrixXd::Zero(candidates, candidates);
  for (std::size_t s = 0; s < structure.supernodes(); ++s) {
    const std::int64_t first = structure.super[s], height = structure.height(s);
    const std::int64_t* rows = structure.rows.data() + structure.rowsBegin[s];
    for (std::int64_t column = std::max(first, inside); column < structure.super[s + 1]; ++column)
      for (std::int64_t r = column - first; r < height; ++r)
        compliance(rows[r] - inside, column - inside) =
            factor.values()[structure.valuesBegin[s] + (column - first) * height + r];
  }
  invertCholesky(compliance);
}

/// Row of B: a direction of one node, made of up to three candidates.
struct SupportSolver::State::Row {
  std::array<int, 3> candidate{-1, -1, -1};
  Vector3d weight = Vector3d::Zero();
  int only = -1;  ///< the candidate, if it is one of weight 1
};

SupportSolver::State::Row SupportSolver::State::rowOf(int node, const Vector3d& axis) const {
  Row row;
  row.weight = *reduced->frameOf(node) * axis;
  for (std::size_t d = 0; d < 3; ++d) {
    double& weight = row.weight[static_cast<Index>(d)];
    if (std::abs(weight) < 1e-9) weight = 0;
    if (weight == 0) continue;
    row.candidate[d] = candidateOf[3 * static_cast<std::size_t>(node) + d];
    if (row.candidate[d] < 0)
      throw InputError("a support holds node " + std::to_string(node) +
                       " in a direction that is no candidate; widen the candidate supports");
    if (weight > 1 - 1e-9) row.only = row.candidate[d];
  }
  return row;
}

double SupportSolver::State::complianceOf(const Row& a, const Row& b) const {
  if (a.only >= 0 && b.only >= 0) return compliance(a.only, b.only);
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a.candidate[i] >= 0 && b.candidate[j] >= 0)
        sum += a.weight[static_cast<Index>(i)] * b.weight[static_cast<Index>(j)] *
               compliance(a.candidate[i], b.candidate[j]);
  return sum;
}

/// The forces lambda of a hypothesis as loads of the candidate directions, -B' lambda, and the rigid motion
/// a.
Eigen::VectorXd SupportSolver::State::candidateForces(const SupportHypothesis& hypothesis,
                                                      Eigen::Matrix<double, 6, 1>& rigid) const {
  std::vector<Support> supports = held;
  supports.insert(supports.end(), hypothesis.supports.begin(), hypothesis.supports.end());
  std::vector<NodeConstraint> constraints = nodeConstraints(faces, normals, supports);
  if (pinned) checkHeld(motions, constraints, faces, supports);
  std::erase_if(constraints,
                [&](const NodeConstraint& c) { return eliminated[static_cast<std::size_t>(c.node)] != 0; });
  const Vector3d& g = hypothesis.gravityChangeMPerS2;
  std::vector<Row> rows;
  std::vector<Eigen::Matrix<double, 1, 7>> sides;  // B K+ f - v, and the row of BR
  for (const NodeConstraint& constraint : constraints) {
    const Matrix3d* own = reduced->frameOf(constraint.node);
    if (own == nullptr)
      throw InputError("a support holds node " + std::to_string(constraint.node) +
                       ", which is no candidate; widen the candidate supports");
    // Held wholly, any three directions will do: the candidates' own are single rows of C.
    const Matrix3d& frame = constraint.count == 3 ? *own : constraint.frame;
    const Vector3d given = frame * (constraint.frame.transpose() * constraint.valuesMm);
    for (int k = 0; k < constraint.count; ++k) {
      const Vector3d axis = frame.row(k).transpose();
      rows.push_back(rowOf(constraint.node, axis));
      Eigen::Matrix<double, 1, 7> side;
      side[0] = -given[k];
      for (std::size_t x = 0; x < 3; ++x)
        side[0] += g[static_cast<Index>(x)] * axis.dot(weighed[x].row(constraint.node).transpose());
      side.tail<6>() = axis.transpose() * motions.middleRows<3>(3 * constraint.node);
      sides.push_back(side);
    }
  }
  const auto count = static_cast<Index>(rows.size());
  Eigen::MatrixXd right(count, 7), system(count, count);
  for (Index r = 0; r < count; ++r) right.row(r) = sides[static_cast<std::size_t>(r)];
  const Eigen::MatrixXd rigidRows = right.rightCols<6>();
  forEachChunk(rows.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c)
      for (std::size_t r = c; r < rows.size(); ++r)
        system(static_cast<Index>(r), static_cast<Index>(c)) = complianceOf(rows[r], rows[c]);
  });
  keepBlasSingleThreaded();
  if (!choleskyInPlace(system))
    throw InputError("the supports contradict each other or repeat; name each region once");
  solveCholesky(system, right);
  rigid.setZero();
  if (pinned) {
    const Eigen::Matrix<double, 6, 6> rigidSystem = rigidRows.transpose() * right.rightCols<6>();
    rigid = rigidSystem.ldlt().solve(rigidLoads * g - rigidRows.transpose() * right.col(0));
  }
  const Eigen::VectorXd lambda = right.col(0) + right.rightCols<6>() * rigid;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(candidates);
  for (Index r = 0; r < count; ++r) {
    const Row& row = rows[static_cast<std::size_t>(r)];
    for (std::size_t i = 0; i < 3; ++i)
      if (row.candidate[i] >= 0) forces[row.candidate[i]] -= row.weight[static_cast<Index>(i)] * lambda[r];
  }
  return forces;
}

/// C times the forces of each hypothesis; most candidates carry none.
Eigen::MatrixXd SupportSolver::State::moved(const Eigen::MatrixXd& forces) const {
  if (forces.cols() > 4) return product(compliance, forces);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(candidates, forces.cols());
  forEachChunk(static_cast<std::size_t>(candidates), 256, [&](std::size_t first, std::size_t last) {
    const auto at = static_cast<Index>(first), size = static_cast<Index>(last - first);
    for (Index h = 0; h < forces.cols(); ++h)
      for (Index c = 0; c < candidates; ++c)
        if (forces(c, h) != 0)
          result.col(h).segment(at, size) += forces(c, h) * compliance.col(c).segment(at, size);
  });
  return result;
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
  const Eigen::MatrixXd moved = s.moved(forces);
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
