#include "Modules/Distributed/DistributedSolver.h"

#include <petscksp.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "Logic/Core/Errors.h"
#include "Modules/Distributed/PetscCheck.h"

namespace falciform::distributed {
namespace {

using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Supports as a node sees them: its frame, and which of the frame's directions are given.
struct NodeFrame {
  Matrix3d frame = Matrix3d::Identity();
  int held = 0;

  [[nodiscard]] bool free(int axis) const { return axis >= held; }
};

NodeFrame frameAt(const std::vector<NodeConstraint>& constraints, int node) {
  const auto found =
      std::lower_bound(constraints.begin(), constraints.end(), node,
                       [](const NodeConstraint& constraint, int n) { return constraint.node < n; });
  if (found == constraints.end() || found->node != node) return {};
  return {found->frame, found->count};
}

/// T_i K_ij T_j' with the rows and columns of given directions emptied, Eq. (V.12). They stay in the matrix,
/// with their diagonal, so that every node has three rows: multigrid wants whole nodes.
Block supported(const Matrix3d& block, const NodeFrame& row, const NodeFrame& column, bool diagonal) {
  const Matrix3d turned = row.frame * block * column.frame.transpose();
  Block result = Block::Zero();
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if ((row.free(a) && column.free(b)) || (diagonal && a == b)) result(a, b) = turned(a, b);
  return result;
}

/// The constraints' values on the nodes of `own`, zero elsewhere.
Points given(const OwnElements& own, const std::vector<NodeConstraint>& constraints) {
  Points field = Points::Zero(own.mesh.nodes(), 3);
  for (const NodeConstraint& constraint : constraints) {
    const int at = own.at(constraint.node);
    if (at == static_cast<int>(own.nodes.size()) ||
        own.nodes[static_cast<std::size_t>(at)] != constraint.node)
      continue;
    for (int k = 0; k < constraint.count; ++k)
      field.row(at) += constraint.valuesMm[k] * constraint.frame.row(k);
  }
  return field;
}

}  // namespace

struct DistributedSolver::State {
  const Ranks* ranks = nullptr;
  IterationPlan plan;
  int first = 0, last = 0;        ///< places of own nodes
  std::vector<int> nodes;         ///< at these places; on the first rank: at all
  std::vector<NodeFrame> frames;  ///< of own nodes
  Points held;                    ///< own nodes: K u of the constraints' values, N
  std::vector<NodeConstraint> constraints;
  Index count = 0;
  Mat matrix = nullptr;
  Vec load = nullptr, answer = nullptr, whole = nullptr;
  VecScatter toFirst = nullptr;
  KSP iteration = nullptr;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    KSPDestroy(&iteration);
    VecScatterDestroy(&toFirst);
    for (Vec* vector : {&load, &answer, &whole}) VecDestroy(vector);
    MatDestroy(&matrix);
  }

  [[nodiscard]] int own() const { return last - first; }
  [[nodiscard]] int ownNode(int k) const {
    return nodes[static_cast<std::size_t>(k)];  // the first rank owns the first places
  }
  void assemble(const OwnElements& part, StiffnessMatrix& stiffness, const NodeShares& shares);
  void giveRigidMotions(const Points& points);
  void prepare();
};

void DistributedSolver::State::assemble(const OwnElements& part, StiffnessMatrix& stiffness,
                                        const NodeShares& shares) {
  const NodeGraph& graph = stiffness.graph;
  const auto neighboursOf = [&](int node) {
    const auto at = static_cast<std::size_t>(part.at(node));
    return std::pair(graph.begin[at], graph.begin[at + 1]);
  };
  const auto placeOf = [&](std::size_t at) {
    const int node = part.nodes[static_cast<std::size_t>(graph.neighbours[at])];
    return shares.placeOf[static_cast<std::size_t>(node)];
  };
  std::vector<PetscInt> inside(static_cast<std::size_t>(own()), 0), outside(inside);
  for (int k = 0; k < own(); ++k) {
    const auto [from, to] = neighboursOf(ownNode(k));
    for (std::size_t at = from; at < to; ++at) {
      const int place = placeOf(at);
      ++(place >= first && place < last ? inside : outside)[static_cast<std::size_t>(k)];
    }
  }
  check(MatCreate(PETSC_COMM_WORLD, &matrix));
  check(MatSetSizes(matrix, 3 * own(), 3 * own(), PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetBlockSize(matrix, 3));
  check(MatSetType(matrix, MATAIJ));
  check(MatXAIJSetPreallocation(matrix, 3, inside.data(), outside.data(), nullptr, nullptr));
  check(MatSetOption(matrix, MAT_SPD, PETSC_TRUE));
  std::vector<PetscInt> columns;
  std::vector<double> values;
  for (int k = 0; k < own(); ++k) {
    const int i = part.at(ownNode(k));
    const auto [from, to] = neighboursOf(ownNode(k));
    const std::size_t width = 3 * (to - from);
    columns.clear();
    values.assign(3 * width, 0);
    for (std::size_t at = from; at < to; ++at) {
      const int j = graph.neighbours[at];
      const Matrix3d block = j >= i ? stiffness.blocks[at] : Matrix3d(stiffness.blockOf(j, i).transpose());
      const NodeFrame column = frameAt(constraints, part.nodes[static_cast<std::size_t>(j)]);
      const Block entry = supported(block, frames[static_cast<std::size_t>(k)], column, i == j);
      columns.push_back(placeOf(at));
      for (std::size_t a = 0; a < 3; ++a)
        std::copy_n(entry.data() + 3 * a, 3,
                    values.begin() + static_cast<std::ptrdiff_t>(a * width + 3 * (at - from)));
    }
    const PetscInt row = first + k;
    check(MatSetValuesBlocked(matrix, 1, &row, static_cast<PetscInt>(columns.size()), columns.data(),
                              values.data(), INSERT_VALUES));
  }
  check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

/// PETSc's own rigid motions are along the axes; ours are in the nodes' frames, and 0 where a direction is
/// given.
void DistributedSolver::State::giveRigidMotions(const Points& points) {
  const Eigen::RowVector3d centre = points.colwise().mean();
  std::array<Vec, 6> motions{};
  for (int m = 0; m < 6; ++m) {
    check(MatCreateVecs(matrix, &motions[static_cast<std::size_t>(m)], nullptr));
    double* values = nullptr;
    check(VecGetArray(motions[static_cast<std::size_t>(m)], &values));
    for (int k = 0; k < own(); ++k) {
      const Vector3d lever = (points.row(ownNode(k)) - centre).transpose();
      const Vector3d axis = Vector3d::Unit(m % 3);
      const NodeFrame& node = frames[static_cast<std::size_t>(k)];
      const Vector3d motion = node.frame * (m < 3 ? axis : axis.cross(lever));
      for (int a = 0; a < 3; ++a) values[3 * k + a] = node.free(a) ? motion[a] : 0;
    }
    check(VecRestoreArray(motions[static_cast<std::size_t>(m)], &values));
    for (int before = 0; before < m; ++before) {
      double along = 0;
      check(VecDot(motions[static_cast<std::size_t>(m)], motions[static_cast<std::size_t>(before)], &along));
      check(VecAXPY(motions[static_cast<std::size_t>(m)], -along, motions[static_cast<std::size_t>(before)]));
    }
    check(VecNormalize(motions[static_cast<std::size_t>(m)], nullptr));
  }
  MatNullSpace space = nullptr;
  check(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_FALSE, 6, motions.data(), &space));
  check(MatSetNearNullSpace(matrix, space));
  check(MatNullSpaceDestroy(&space));
  for (Vec& motion : motions) check(VecDestroy(&motion));
}

void DistributedSolver::State::prepare() {
  check(MatCreateVecs(matrix, &answer, &load));
  check(VecScatterCreateToZero(answer, &toFirst, &whole));
  check(KSPCreate(PETSC_COMM_WORLD, &iteration));
  check(KSPSetOperators(iteration, matrix, matrix));
  check(KSPSetType(iteration, KSPCG));
  // The residual itself, in N: the load's and the supports' forces are of one size with it.
  check(KSPSetNormType(iteration, KSP_NORM_UNPRECONDITIONED));
  check(KSPSetTolerances(iteration, plan.relativeTolerance, 0, PETSC_DEFAULT, plan.maxIterations));
  PC grids = nullptr;
  check(KSPGetPC(iteration, &grids));
  check(PCSetType(grids, PCGAMG));
  check(PCGAMGSetType(grids, PCGAMGAGG));
  check(PCGAMGSetNSmooths(grids, 1));
  check(KSPSetFromOptions(iteration));
  check(KSPSetUp(iteration));
}

DistributedSolver::DistributedSolver(const Ranks& ranks, const TetrahedralMesh& mesh,
                                     const NodeShares& shares, const std::vector<Material>& materials,
                                     const std::vector<NodeConstraint>& constraints,
                                     const IterationPlan& plan)
    : state_(std::make_shared<State>()) {
  State& s = *state_;
  s.ranks = &ranks;
  s.plan = plan;
  s.count = mesh.nodes();
  s.constraints = constraints;
  s.first = shares.begin[static_cast<std::size_t>(ranks.rank())];
  s.last = shares.begin[static_cast<std::size_t>(ranks.rank()) + 1];
  s.nodes.assign(shares.nodes.begin() + s.first,
                 ranks.first() ? shares.nodes.end() : shares.nodes.begin() + s.last);
  for (int k = 0; k < s.own(); ++k) s.frames.push_back(frameAt(constraints, s.ownNode(k)));
  OwnElements part;
  StiffnessMatrix stiffness;
  ranks.together([&] {
    part = ownElements(mesh, shares, ranks.rank());
    stiffness = assembleStiffness(part.mesh, materials);
    const Points forces = stiffness.times(given(part, constraints));
    s.held.resize(s.own(), 3);
    for (int k = 0; k < s.own(); ++k) s.held.row(k) = forces.row(part.at(s.ownNode(k)));
  });
  s.assemble(part, stiffness, shares);
  stiffness = {};  // before the grids take their memory
  part = {};
  s.giveRigidMotions(mesh.points);
  s.prepare();
}

Points DistributedSolver::solve(const Points& forces, double scale) {
  State& s = *state_;
  double* values = nullptr;
  check(VecGetArray(s.load, &values));
  for (int k = 0; k < s.own(); ++k) {
    const NodeFrame& node = s.frames[static_cast<std::size_t>(k)];
    const Vector3d force = node.frame * (forces.row(s.ownNode(k)) - scale * s.held.row(k)).transpose();
    for (int a = 0; a < 3; ++a) values[3 * k + a] = node.free(a) ? force[a] : 0;
  }
  check(VecRestoreArray(s.load, &values));
  check(KSPSolve(s.iteration, s.load, s.answer));
  KSPConvergedReason reason{};
  check(KSPGetConvergedReason(s.iteration, &reason));
  if (reason < 0) {
    const char* cause = nullptr;
    check(KSPGetConvergedReasonString(s.iteration, &cause));
    std::ostringstream text;
    text << "the residual did not fall to " << s.plan.relativeTolerance << " of the load within "
         << iterations() << " iterations (" << cause
         << "); allow more, a larger tolerance, or a Poisson's ratio further below 0.5";
    throw InputError(text.str());
  }
  check(VecScatterBegin(s.toFirst, s.answer, s.whole, INSERT_VALUES, SCATTER_FORWARD));
  check(VecScatterEnd(s.toFirst, s.answer, s.whole, INSERT_VALUES, SCATTER_FORWARD));
  if (!s.ranks->first()) return {};
  Points displacements(s.count, 3);
  const double* found = nullptr;
  check(VecGetArrayRead(s.whole, &found));
  for (Index place = 0; place < s.count; ++place)
    displacements.row(s.nodes[static_cast<std::size_t>(place)]) =
        Eigen::Map<const Eigen::RowVector3d>(found + 3 * place);
  check(VecRestoreArrayRead(s.whole, &found));
  for (const NodeConstraint& constraint : s.constraints) {
    Vector3d along = displacements.row(constraint.node).transpose();  // still in the node's frame
    along.head(constraint.count) = scale * constraint.valuesMm.head(constraint.count);
    displacements.row(constraint.node) = (constraint.frame.transpose() * along).transpose();
  }
  return displacements;
}

int DistributedSolver::iterations() const {
  PetscInt count = 0;
  check(KSPGetIterationNumber(state_->iteration, &count));
  return static_cast<int>(count);
}

double DistributedSolver::matrixBytes() const {
  MatInfo info{};
  check(MatGetInfo(state_->matrix, MAT_GLOBAL_SUM, &info));
  return info.nz_used * (sizeof(PetscScalar) + sizeof(PetscInt));
}

double DistributedSolver::gridComplexity() const {
  PC grids = nullptr;
  check(KSPGetPC(state_->iteration, &grids));
  PetscReal grid = 0, entries = 0;
  check(PCMGGetGridComplexity(grids, &grid, &entries));
  return entries;
}

}  // namespace falciform::distributed
