#pragma once
#include <memory>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// Turns displacements of small-strain theory into ones that hold for large turns (METHODS 4.5): a linear
/// solution swells what it rotates. At every place the displacement gradient is split into strain and
/// rotation, du/dx = e + w, the rotation made a true one, F = exp(w) (I + e), and the positions found whose
/// gradients are nearest to F in the least-squares sense over the volume (rotation-strain coordinates; Huang,
/// Tong, Zhou, Bao, Desbrun 2011). The matrix of that is factorised once.
class CorotationalWarp {
 public:
  /// `anchors`: nodes that keep the displacements they are given, e.g. those of the supports; without any,
  /// the mean displacement over the nodes is kept. Throws InputError for a damaged mesh or a node that is not
  /// there.
  CorotationalWarp(const TetrahedralMesh& mesh, const std::vector<int>& anchors,
                   const Progress& progress = {});

  /// Displacements in mm (N x 3) for those of the linear solution (N x 3).
  [[nodiscard]] Points apply(const Points& displacements) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace falciform
