#pragma once
#include <string>
#include <vector>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/StiffnessMatrix.h"

namespace falciform {

/// How a part of the surface is held. What belongs to no support is free of traction, Eq. (V.9) as corrected.
enum class SupportKind {
  Fixed,    ///< u = 0, Eq. (V.8)
  Moved,    ///< u is a given vector
  Sliding,  ///< u_n = 0, free of traction along the surface, Eq. (V.11)
  Pushed,   ///< u_n is given, free of traction along the surface, Eq. (V.11)
  Spring    ///< a bed of springs along the normal (Winkler)
};

struct Support {
  std::string name;
  SupportKind kind = SupportKind::Fixed;
  std::vector<int> faces{};                    ///< numbers into BoundaryFaces
  double pushMm = 0;                           ///< Pushed: mm into the organ, against the outward normal
  Vector3d displacementMm = Vector3d::Zero();  ///< Moved: mm, in the mesh's frame
  double springNPerMm3 = 0;                    ///< Spring: pressure by displacement, above 0
};

/// What one node may not do: its displacement along the first `count` rows of `frame` is given.
struct NodeConstraint {
  int node = 0;
  int count = 3;                          ///< 1 to 3
  Matrix3d frame = Matrix3d::Identity();  ///< rows: the constrained directions first; orthonormal
  Vector3d valuesMm = Vector3d::Zero();   ///< along the rows of `frame`
};

/// The outward normal of each node by Engelman et al. 1982, n_i = sum of the integrals of N_i n (unit, zero
/// inside), and whether the surface has an edge or corner there (a turn of more than about 50 degrees, or a
/// face more than 60 from the normal), so that no single normal stands for it.
struct NodeNormals {
  Points normals;
  std::vector<char> sharp;
};
[[nodiscard]] NodeNormals nodeNormals(const BoundaryFaces& faces, Index nodes);

/// Rows: the unit vector `first`, then two directions across it.
[[nodiscard]] Matrix3d frameAlong(const Vector3d& first);

/// The supports as constraints of nodes, ascending by node, each node once: where supports meet, Fixed and
/// Moved bind wholly, and Pushed goes before Sliding. At a sharp node the normals of the supports' own faces
/// bind, two or three of them if need be. Spring gives no constraint. Throws InputError for a face that is
/// not there, an empty support, or values that are not finite.
[[nodiscard]] std::vector<NodeConstraint> nodeConstraints(const BoundaryFaces& faces,
                                                          const NodeNormals& normals,
                                                          const std::vector<Support>& supports);

/// Adds the springs of `supports` to K. Throws InputError for a stiffness not above 0.
void addSprings(StiffnessMatrix& stiffness, const BoundaryFaces& faces, const std::vector<Support>& supports);

/// The six rigid motions about the nodes' centre as columns of 3 N values (x, y, z of node 0, ...):
/// translations, then rotations by one radian, by unit length of the largest lever so that all six have like
/// size.
[[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 6> rigidMotions(const Points& nodes);

/// Three nodes far apart, held in six directions that are statically determinate: all of the first, two
/// across the line to the second, one across the plane with the third. Such pins take away the rigid motions
/// and bear no force under balanced loads. Nodes marked in `closed` (empty: none) are not used. Throws
/// InputError if all are closed.
[[nodiscard]] std::vector<NodeConstraint> determinatePins(const Points& nodes,
                                                          const std::vector<char>& closed = {});

/// Whether constraints leave the body none of its rigid motions.
[[nodiscard]] bool holds(const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions,
                         const std::vector<NodeConstraint>& constraints);

/// Throws InputError that says in words how the body can still move (along or about which axis), if the
/// constraints and springs leave it one of its rigid motions.
void checkHeld(const Eigen::Matrix<double, Eigen::Dynamic, 6>& motions,
               const std::vector<NodeConstraint>& constraints, const BoundaryFaces& faces,
               const std::vector<Support>& supports);
void checkHeld(const Points& nodes, const std::vector<NodeConstraint>& constraints,
               const BoundaryFaces& faces, const std::vector<Support>& supports);
/// The same for every piece of a mesh whose pieces do not touch: each needs supports of its own.
void checkHeld(const TetrahedralMesh& mesh, const std::vector<NodeConstraint>& constraints,
               const BoundaryFaces& faces, const std::vector<Support>& supports);

}  // namespace falciform
