#pragma once
#include <memory>
#include <vector>

#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// CorotationalWarp on the linear tetrahedra of a mesh's corners alone: a few per cent of its work, for where
/// it is asked for many times a second. What it adds to the displacements of small-strain theory is
/// interpolated linearly at edge nodes; the corners' mean displacement stays as it is. Immutable.
class CornerWarp {
 public:
  /// Throws InputError for a damaged mesh.
  explicit CornerWarp(const TetrahedralMesh& mesh);

  /// The nodes that apply() reads.
  [[nodiscard]] const std::vector<int>& corners() const { return corners_; }

  struct Change {
    Points added;  ///< N x 3 mm, to be added to the linear displacements at every node
    Points turns;  ///< N x 3 rotation vectors, radians: how tissue has turned there
  };
  /// For linear displacements in mm, N x 3, of which the corners' rows are read. Same bits for any number of
  /// threads.
  [[nodiscard]] Change apply(const Points& linear) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
  std::vector<int> corners_;
};

}  // namespace falciform
