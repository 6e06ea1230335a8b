#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A solid cut into tetrahedra: linear ones (T4) of four corners, or quadratic ones (T10) with six nodes on
/// the edges as well, in VTK's order: corners 0-3, then the edges 01, 12, 02, 03, 13, 23.
struct TetrahedralMesh {
  using Elements = Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Points points;             ///< N x 3, mm, in `frame`
  Elements elements;         ///< M x 4 or M x 10 rows of points; positive volume
  std::vector<int> regions;  ///< M region numbers: 0 parenchyma, 1 and up tumours; empty: all 0
  std::string frame = "LPS";

  [[nodiscard]] Index nodes() const { return points.rows(); }
  [[nodiscard]] Index size() const { return elements.rows(); }
  [[nodiscard]] bool quadratic() const { return elements.cols() == 10; }
  [[nodiscard]] int regionOf(Index element) const {
    return regions.empty() ? 0 : regions[static_cast<std::size_t>(element)];
  }
};

/// Checks shapes, index ranges, finite coordinates, region numbers and that every tetrahedron of corners has
/// a volume above 0 (not asked of a mesh that `mayBeFolded`: a deformed one); throws InputError that names
/// `what` otherwise.
void checkMesh(const TetrahedralMesh& mesh, const std::string& what, bool mayBeFolded = false);

/// The volume in mm3 of element `e`'s four corners, by the scalar triple product.
[[nodiscard]] double cornerVolume(const TetrahedralMesh& mesh, Index e);

}  // namespace falciform
