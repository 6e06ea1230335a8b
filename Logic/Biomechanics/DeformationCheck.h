#pragma once
#include <utility>
#include <vector>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// How far a displacement field is from folding tissue over. The determinant of the deformation gradient,
/// det(I + du/dx), is the local ratio of volumes: 1 where nothing is squeezed, 0 where a volume is pressed to
/// nothing, negative where it is turned inside out, which no tissue can be.
struct DeformationCheck {
  double minDetJ = 1;      ///< over all elements, at quadrature points and corners
  int worstElement = -1;   ///< where that is
  double foldedShare = 0;  ///< of the volume: where the determinant is 0 or less
};

/// A field as a sum of others: field number and factor.
using FieldSum = std::vector<std::pair<int, double>>;

/// For displacements in mm (N x 3). Throws InputError where their number is not the mesh's.
[[nodiscard]] DeformationCheck checkDeformation(const TetrahedralMesh& mesh, const Points& displacements);

/// M: the smallest determinant in each element, looked at in the same places.
[[nodiscard]] VectorXd leastDetJ(const TetrahedralMesh& mesh, const Points& displacements);

/// checkDeformation for many sums of few fields: gradients are formed once a field. Same bits for any number
/// of threads.
[[nodiscard]] std::vector<DeformationCheck> checkDeformations(const TetrahedralMesh& mesh,
                                                              const std::vector<Points>& fields,
                                                              const std::vector<FieldSum>& sums);

}  // namespace falciform
