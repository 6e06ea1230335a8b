#include "Logic/Biomechanics/Supports.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "Logic/Biomechanics/MeshPieces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/NumberText.h"

namespace falciform {
namespace {

/// An eigenvalue of the mean outer product of a node's face normals above this counts as a normal of its own:
/// for two faces that meet at an edge it is sin^2 of half the turn, so the limit is a turn of 53 degrees.
constexpr double kOwnNormal = 0.2;

/// A face this far from its node's normal is across an edge, however small it is beside the others: cos 60.
constexpr double kAcrossEdge = 0.5;

/// What the faces of the supports around one node ask of it.
struct Demands {
  const Support* whole = nullptr;  ///< Fixed or Moved
  Matrix3d scatter = Matrix3d::Zero();
  Vector3d sum = Vector3d::Zero(),
           wanted = Vector3d::Zero();  ///< area-weighted normals, and times their values
  double area = 0;
  bool pushed = false;
  double pushMm = 0;
};

void checkSupport(const BoundaryFaces& faces, const Support& support) {
  if (support.faces.empty())
    throw InputError("the support '" + support.name +
                     "' covers no face of the mesh; paint it larger or leave it out");
  for (const int face : support.faces)
    if (face < 0 || face >= faces.size())
      throw InputError("the support '" + support.name + "' names boundary face " + std::to_string(face) +
                       " but the mesh has " + std::to_string(faces.size()) + " (from 0)");
  if (!std::isfinite(support.pushMm) || !support.displacementMm.allFinite())
    throw InputError("the support '" + support.name + "' has a displacement that is no finite number of mm");
}

double outwardMm(const Support& support) { return support.kind == SupportKind::Pushed ? -support.pushMm : 0; }

void demand(Demands& at, const Support& support, const Vector3d& areaVector) {
  if (support.kind == SupportKind::Fixed || support.kind == SupportKind::Moved) {
    if (at.whole == nullptr || support.kind == SupportKind::Fixed) at.whole = &support;
    return;
  }
  const double area = areaVector.norm();
  const Vector3d normal = areaVector / area;
  at.scatter += area * normal * normal.transpose();
  at.sum += areaVector;
  at.wanted += areaVector * outwardMm(support);
  at.area += area;
  if (support.kind == SupportKind::Pushed) {
    at.pushed = true;
    at.pushMm = outwardMm(support);
  }
}

NodeConstraint alongNormal(int node, const Vector3d& normal, double outward) {
  return {.node = node, .count = 1, .frame = frameAlong(normal), .valuesMm = {outward, 0, 0}};
}

NodeConstraint atSharpNode(int node, const Demands& at) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(at.scatter / at.area);
  NodeConstraint constraint{.node = node, .count = 0, .frame = {}, .valuesMm = Vector3d::Zero()};
  for (Index k = 0; k < 3; ++k) {
    const Index from = 2 - k;  // largest first
    const Vector3d axis = solver.eigenvectors().col(from);
    constraint.frame.row(k) = axis.transpose();
    if (solver.eigenvalues()[from] < kOwnNormal) continue;
    constraint.valuesMm[constraint.count++] = axis.dot(at.wanted) / (at.area * solver.eigenvalues()[from]);
  }
  if (constraint.count <= 1)
    return alongNormal(node, at.sum.normalized(), at.wanted.dot(at.sum) / at.sum.squaredNorm());
  return constraint;
}

NodeConstraint constraintOf(int node, const Demands& at, const NodeNormals& normals) {
  if (at.whole != nullptr) {
    const bool moved = at.whole->kind == SupportKind::Moved;
    return {.node = node,
            .count = 3,
            .frame = Matrix3d::Identity(),
            .valuesMm = moved ? at.whole->displacementMm : Vector3d(Vector3d::Zero())};
  }
  if (normals.sharp[static_cast<std::size_t>(node)] != 0) return atSharpNode(node, at);
  return alongNormal(node, normals.normals.row(node).transpose(), at.pushed ? at.pushMm : 0);
}

/// The integrals of N_a N_b over a face by its area, times 12 (linear) or 180 (quadratic).
double faceMass(bool quadratic, int a, int b) {
  static constexpr std::array<std::array<double, 6>, 6> kQuadratic{{{6, -1, -1, 0, -4, 0},
                                                                    {-1, 6, -1, 0, 0, -4},
                                                                    {-1, -1, 6, -4, 0, 0},
                                                                    {0, 0, -4, 32, 16, 16},
                                                                    {-4, 0, 0, 16, 32, 16},
                                                                    {0, -4, 0, 16, 16, 32}}};
  if (!quadratic) return (a == b ? 2.0 : 1.0) / 12;
  return kQuadratic[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] / 180;
}

std::string describeFreeMotion(const Eigen::Matrix<double, 6, 1>& motion) {
  const Vector3d shift = motion.head<3>(), turn = motion.tail<3>();
  const bool turns = turn.norm() > shift.norm();
  const Vector3d axis = (turns ? turn : shift).normalized();
  char text[80];
  std::snprintf(text, sizeof text, "%s (%.2f, %.2f, %.2f)", turns ? "turn about the axis" : "move along",
                axis[0], axis[1], axis[2]);
  return text;
}

}  // namespace

NodeNormals nodeNormals(const BoundaryFaces& faces, Index nodes) {
  NodeNormals result{.normals = Points::Zero(nodes, 3),
                     .sharp = std::vector<char>(static_cast<std::size_t>(nodes), 0)};
  std::vector<Matrix3d> scatter(static_cast<std::size_t>(nodes), Matrix3d::Zero());
  for (Index f = 0; f < faces.size(); ++f) {
    const Vector3d areaVector = faces.areaVectors.row(f).transpose();
    for (int k = 0; k < faces.nodesPerFace(); ++k) {
      const int node = faces.nodes(f, k);
      // A quadratic corner's own share is 0: it takes the linear one, so that its normal is defined.
      result.normals.row(node) += areaVector.transpose() / 3;
      scatter[static_cast<std::size_t>(node)] += areaVector * areaVector.transpose() / areaVector.norm();
    }
  }
  for (Index n = 0; n < nodes; ++n) {
    const Matrix3d& s = scatter[static_cast<std::size_t>(n)];
    if (s.trace() == 0) continue;
    result.normals.row(n).normalize();
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(s / s.trace(), Eigen::EigenvaluesOnly);
    result.sharp[static_cast<std::size_t>(n)] = solver.eigenvalues()[1] >= kOwnNormal;
  }
  for (Index f = 0; f < faces.size(); ++f) {
    const Vector3d normal = faces.areaVectors.row(f).normalized().transpose();
    for (int k = 0; k < faces.nodesPerFace(); ++k)
      if (result.normals.row(faces.nodes(f, k)).dot(normal.transpose()) < kAcrossEdge)
        result.sharp[static_cast<std::size_t>(faces.nodes(f, k))] = 1;
  }
  return result;
}

Matrix3d frameAlong(const Vector3d& first) {
  const Vector3d second = first.unitOrthogonal();
  Matrix3d frame;
  frame.row(0) = first.transpose();
  frame.row(1) = second.transpose();
  frame.row(2) = first.cross(second).transpose();
  return frame;
}

std::vector<NodeConstraint> nodeConstraints(const BoundaryFaces& faces, const NodeNormals& normals,
                                            const std::vector<Support>& supports) {
  std::map<int, Demands> demands;
  for (const Support& support : supports) {
    checkSupport(faces, support);
    if (support.kind == SupportKind::Spring) continue;
    for (const int face : support.faces)
      for (int k = 0; k < faces.nodesPerFace(); ++k)
        demand(demands[faces.nodes(face, k)], support, faces.areaVectors.row(face).transpose());
  }
  std::vector<NodeConstraint> constraints;
  constraints.reserve(demands.size());
  for (const auto& [node, at] : demands) constraints.push_back(constraintOf(node, at, normals));
  return constraints;
}

void addSprings(StiffnessMatrix& stiffness, const BoundaryFaces& faces,
                const std::vector<Support>& supports) {
  for (const Support& support : supports) {
    if (support.kind != SupportKind::Spring) continue;
    checkSupport(faces, support);
    if (!(support.springNPerMm3 > 0) || !std::isfinite(support.springNPerMm3))
      throw InputError("the springs of '" + support.name + "' have " + numberText(support.springNPerMm3) +
                       " N/mm3; give a stiffness above 0");
    for (const int face : support.faces) {
      const Vector3d areaVector = faces.areaVectors.row(face).transpose();
      const Matrix3d along = support.springNPerMm3 * areaVector * areaVector.transpose() / areaVector.norm();
      for (int a = 0; a < faces.nodesPerFace(); ++a)
        for (int b = 0; b < faces.nodesPerFace(); ++b)
          if (faces.nodes(face, b) >= faces.nodes(face, a))
            stiffness.blockOf(faces.nodes(face, a), faces.nodes(face, b)) +=
                faceMass(faces.quadratic, a, b) * along;
    }
  }
}

Eigen::Matrix<double, Eigen::Dynamic, 6> rigidMotions(const Points& nodes) {
  const Vector3d centre = nodes.colwise().mean().transpose();
  const double lever = std::sqrt((nodes.rowwise() - centre.transpose()).rowwise().squaredNorm().maxCoeff());
  Eigen::Matrix<double, Eigen::Dynamic, 6> motions(3 * nodes.rows(), 6);
  for (Index i = 0; i < nodes.rows(); ++i) {
    const Vector3d arm = (nodes.row(i).transpose() - centre) / (lever > 0 ? lever : 1);
    motions.block<3, 3>(3 * i, 0).setIdentity();
    for (int k = 0; k < 3; ++k) motions.block<3, 1>(3 * i, 3 + k) = Vector3d::Unit(k).cross(arm);
  }
  return motions;
}

void checkHeld(const Points& nodes, const std::vector<NodeConstraint>& constraints,
               const BoundaryFaces& faces, const std::vector<Support>& supports) {
  checkHeld(rigidMotions(nodes), constraints, faces, supports);
}

namespace {

/// How strongly each rigid motion is resisted, smallest first, with those motions.
class Hold {
 public:
  explicit Hold(const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions) : motions_(motions) {}

  void add(Index node, const Vector3d& axis) {
    const Eigen::Matrix<double, 6, 1> row = motions_.middleRows<3>(3 * node).transpose() * axis;
    held_ += row * row.transpose();
  }
  void add(const std::vector<NodeConstraint>& constraints) {
    for (const NodeConstraint& constraint : constraints)
      for (int k = 0; k < constraint.count; ++k) add(constraint.node, constraint.frame.row(k).transpose());
  }
  /// The motion that is left, if there is one: resisted less than 1e-8 times as much as the best-held.
  [[nodiscard]] std::optional<Eigen::Matrix<double, 6, 1>> freeMotion() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(held_);
    if (solver.eigenvalues()[0] > 1e-8 * std::max(1.0, solver.eigenvalues()[5])) return {};
    return solver.eigenvectors().col(0);
  }

 private:
  const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions_;
  Eigen::Matrix<double, 6, 6> held_ = Eigen::Matrix<double, 6, 6>::Zero();
};

}  // namespace

bool holds(const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions,
           const std::vector<NodeConstraint>& constraints) {
  Hold hold(motions);
  hold.add(constraints);
  return !hold.freeMotion();
}

namespace {

/// The motion left to the nodes that `among` says, whose rigid motions are given.
template <class Among>
std::optional<Eigen::Matrix<double, 6, 1>> motionLeft(const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions,
                                                      const std::vector<NodeConstraint>& constraints,
                                                      const BoundaryFaces& faces,
                                                      const std::vector<Support>& supports,
                                                      const Among& among) {
  Hold hold(motions);
  for (const NodeConstraint& constraint : constraints)
    if (among(constraint.node)) hold.add({constraint});
  for (const Support& support : supports)
    if (support.kind == SupportKind::Spring)
      for (const int face : support.faces)
        for (int k = 0; k < faces.nodesPerFace(); ++k)
          if (among(faces.nodes(face, k)))
            hold.add(faces.nodes(face, k), faces.areaVectors.row(face).normalized().transpose());
  return hold.freeMotion();
}

}  // namespace

void checkHeld(const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions,
               const std::vector<NodeConstraint>& constraints, const BoundaryFaces& faces,
               const std::vector<Support>& supports) {
  if (const auto free = motionLeft(motions, constraints, faces, supports, [](int) { return true; }))
    throw InputError("the supports do not hold the liver: it can still " + describeFreeMotion(*free) +
                     "; fix a region, or add sliding ones that face other ways");
}

void checkHeld(const TetrahedralMesh& mesh, const std::vector<NodeConstraint>& constraints,
               const BoundaryFaces& faces, const std::vector<Support>& supports) {
  const MeshPieces pieces = meshPieces(mesh);
  if (pieces.nodes.size() == 1) return checkHeld(mesh.points, constraints, faces, supports);
  for (std::size_t p = 0; p < pieces.nodes.size(); ++p) {
    const Points own = mesh.points(pieces.nodes[p], Eigen::all);
    // Levers about the piece's own centre: one about the whole's would make a small piece's turns alike.
    Eigen::Matrix<double, Eigen::Dynamic, 6> motions =
        Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(3 * mesh.nodes(), 6);
    const auto ownMotions = rigidMotions(own);
    for (std::size_t i = 0; i < pieces.nodes[p].size(); ++i)
      motions.middleRows<3>(3 * pieces.nodes[p][i]) = ownMotions.middleRows<3>(3 * static_cast<Index>(i));
    const auto isOwn = [&](int node) {
      return pieces.pieceOf[static_cast<std::size_t>(node)] == static_cast<int>(p);
    };
    if (const auto free = motionLeft(motions, constraints, faces, supports, isOwn)) {
      const Vector3d centre = own.colwise().mean().transpose();
      char where[160];
      std::snprintf(
          where, sizeof where, "piece %d of %d of the mesh (%d of %d nodes, around %.0f, %.0f, %.0f mm)",
          static_cast<int>(p) + 1, static_cast<int>(pieces.nodes.size()), static_cast<int>(own.rows()),
          static_cast<int>(mesh.nodes()), centre[0], centre[1], centre[2]);
      throw InputError(std::string("the supports do not hold ") + where + ": it can still " +
                       describeFreeMotion(*free) + "; support it as well, or leave it out");
    }
  }
}

std::vector<NodeConstraint> determinatePins(const Points& nodes, const std::vector<char>& closed) {
  const auto farthest = [&](const auto& distance) {
    Index best = -1;
    for (Index n = 0; n < nodes.rows(); ++n)
      if ((closed.empty() || closed[static_cast<std::size_t>(n)] == 0) &&
          (best < 0 || distance(n) > distance(best)))
        best = n;
    if (best < 0) throw InputError("every node is a candidate support; leave some of the liver free");
    return best;
  };
  const auto at = [&](Index n) { return Vector3d(nodes.row(n).transpose()); };
  const Vector3d centre = nodes.colwise().mean().transpose();
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
  std::sort(result.begin(), result.end(),
            [](const NodeConstraint& p, const NodeConstraint& q) { return p.node < q.node; });
  return result;
}

}  // namespace falciform
