#pragma once
#include <vector>

#include "Logic/Core/Types.h"
#include "Logic/Geometry/RbfKernel.h"

namespace falciform {

/// The integral over the unit cell of a lattice of step 1 of D^3 phi_a : D^3 phi_b, for the radial basis
/// functions at all nodes that reach into the cell.
struct RbfCellStiffness {
  std::vector<Vector3i> nodes;  ///< offsets from the cell's lowest corner, ascending by z, y, x
  Eigen::MatrixXd matrix;       ///< symmetric
};
[[nodiscard]] RbfCellStiffness rbfCellStiffness(const RbfKernel& kernel);

}  // namespace falciform
