#pragma once
#include <array>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// The two corners that each of a quadratic tetrahedron's six edge nodes (4 to 9) lies between.
inline constexpr std::array<std::array<int, 2>, 6> kTetrahedronEdges{
    {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}}};

/// Corners and edge nodes of a tetrahedron's four faces, counter-clockwise seen from outside: corners a, b,
/// c, then the nodes on ab, bc, ca. A linear tetrahedron uses the first three.
inline constexpr std::array<std::array<int, 6>, 4> kTetrahedronFaces{
    {{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}}};

/// Values at a place, given by its four barycentric coordinates, of the shape functions of a tetrahedron with
/// `nodes` = 4 or 10 nodes; they sum to 1.
[[nodiscard]] Eigen::VectorXd shapeValues(const Eigen::Vector4d& barycentric, int nodes);

/// Derivatives of the shape functions by x, y and z, 1/mm, at one place of a straight-edged tetrahedron:
/// `nodes` x 3.
[[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 10, 3> shapeGradients(
    const Eigen::Vector4d& barycentric, const Eigen::Matrix<double, 4, 3>& barycentricGradients, int nodes);

/// Derivatives of the four barycentric coordinates by x, y and z, 1/mm, constant in element `e`.
[[nodiscard]] Eigen::Matrix<double, 4, 3> barycentricGradients(const TetrahedralMesh& mesh, Index e);

/// Places of the quadrature rule that is exact for the stiffness of straight-edged elements, all of equal
/// weight: one place for linear elements, four for quadratic ones.
[[nodiscard]] const std::vector<Eigen::Vector4d>& quadraturePlaces(bool quadratic);

}  // namespace falciform
