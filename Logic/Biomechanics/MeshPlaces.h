#pragma once
#include <memory>
#include <vector>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Finds the tetrahedron that holds a point. Immutable; any number of threads may ask.
class MeshLocator {
 public:
  /// Throws InputError for a damaged mesh.
  explicit MeshLocator(const TetrahedralMesh& mesh);

  struct Place {
    int element = -1;
    Eigen::Vector4d barycentric = Eigen::Vector4d::Zero();  ///< of the query, or of the nearest place
    double outsideMm = 0;  ///< 0 inside; else how far the query is from the nearest place
  };
  /// On a face that several share: the one that the query is deepest in, by barycentric coordinates; then the
  /// lowest number.
  [[nodiscard]] Place find(const Vector3d& query) const;

  [[nodiscard]] const TetrahedralMesh& mesh() const;
  /// Derivatives of element e's barycentric coordinates by x, y, z, 1/mm.
  [[nodiscard]] const Eigen::Matrix<double, 4, 3>& gradients(int element) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

/// Where each of N points lies in a mesh, and with which weights it follows the element's nodes: so that what
/// is known at nodes is known at surface vertices, targets and vessels. Inside an element the weights are its
/// shape functions. Outside the mesh they continue linearly from the nearest place of its boundary: exact for
/// linear fields, and never worse than linear far away. The same for any number of threads.
class MeshPlaces {
 public:
  using Weights = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  MeshPlaces() = default;
  MeshPlaces(const TetrahedralMesh& mesh, const Points& points);
  MeshPlaces(const MeshLocator& locator, const Points& points);

  [[nodiscard]] Index size() const { return nodes_.rows(); }
  /// The element that holds each point, or the nearest one.
  [[nodiscard]] const std::vector<int>& elements() const { return elements_; }
  /// N x 4 or N x 10 nodes of those elements, and the weights of each; rows of weights sum to 1.
  [[nodiscard]] const TetrahedralMesh::Elements& nodes() const { return nodes_; }
  [[nodiscard]] const Weights& weights() const { return weights_; }
  /// N: 0 inside, else mm from the mesh.
  [[nodiscard]] const VectorXd& outsideMm() const { return outsideMm_; }

  /// Values at the points of a field given at the mesh's nodes: M x k in, N x k out, row-major. Throws
  /// InputError where the field has another number of rows than the mesh has nodes.
  [[nodiscard]] Weights interpolate(const Eigen::Ref<const Weights>& nodalField) const;

 private:
  Index meshNodes_ = 0;
  std::vector<int> elements_;
  TetrahedralMesh::Elements nodes_;
  Weights weights_;
  VectorXd outsideMm_;
};

}  // namespace falciform
