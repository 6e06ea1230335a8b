#pragma once
#include <optional>
#include <vector>

#include "Logic/Core/TetrahedralMesh.h"
#include "Logic/Geometry/BoxTree.h"

namespace falciform {

/// A mesh whose nodes have moved, asked backwards: which tissue is at a place now. Immutable; any number of
/// threads may ask.
class DeformedMesh {
 public:
  /// `displacements`: N x 3 mm at the mesh's nodes. Throws InputError for a damaged mesh and where the number
  /// of displacements is not the mesh's.
  DeformedMesh(const TetrahedralMesh& mesh, const Points& displacements);

  struct Tissue {
    int element = -1;
    Eigen::Vector4d barycentric = Eigen::Vector4d::Zero();  ///< of the undeformed element
    Vector3d before = Vector3d::Zero();                     ///< where it was, mm
  };
  /// What is at `now`; nothing outside the deformed mesh. Exact to rounding: a matrix for linear elements,
  /// Newton's method inside the curved ones of a quadratic mesh. Where the mesh overlaps itself, the element
  /// that it is deepest in, by barycentric coordinates. `guess` (an element, or -1) is tried first.
  [[nodiscard]] std::optional<Tissue> find(const Vector3d& now, int guess = -1) const;

  /// Where a place of element `e` is now, continued linearly by `beyond` mm (in the undeformed mesh).
  [[nodiscard]] Vector3d now(int e, const Eigen::Vector4d& barycentric,
                             const Vector3d& beyond = Vector3d::Zero()) const;
  /// Where it was.
  [[nodiscard]] Vector3d before(int e, const Eigen::Vector4d& barycentric) const {
    const Element& element = elements_[static_cast<std::size_t>(e)];
    return element.before + element.edgesBefore * barycentric.tail<3>();
  }
  [[nodiscard]] Vector3d lowest() const { return lowest_; }  ///< corners of a box that holds it all, mm
  [[nodiscard]] Vector3d highest() const { return highest_; }
  /// The same of one element.
  [[nodiscard]] Vector3d lowest(int e) const { return low_.row(e).transpose(); }
  [[nodiscard]] Vector3d highest(int e) const { return high_.row(e).transpose(); }
  [[nodiscard]] int size() const { return static_cast<int>(elements_.size()); }

 private:
  /// Places are origin + edges * b + the sum over edges (i, j) of b_i b_j bends, b the last three barycentric
  /// coordinates.
  struct Element {
    Vector3d origin, before;
    Matrix3d edges, inverse;            ///< of the deformed corners
    Matrix3d edgesBefore;               ///< of the undeformed ones
    Eigen::Matrix<double, 3, 6> bends;  ///< 4 x (edge node - middle of its corners)
    double slack = 0;                   ///< how far barycentric coordinates may be off by the bends
  };
  void add(const TetrahedralMesh& mesh, const Points& displacements, Index e);
  [[nodiscard]] Vector3d bend(const Element& element, const Eigen::Vector4d& b) const;
  [[nodiscard]] Matrix3d slope(const Element& element, const Eigen::Vector4d& b) const;
  [[nodiscard]] std::optional<Eigen::Vector4d> solve(const Element& element, const Vector3d& now) const;

  bool quadratic_ = false;
  std::vector<Element> elements_;
  Points low_, high_;
  Vector3d lowest_, highest_;
  std::optional<BoxTree> boxes_;
};

}  // namespace falciform
