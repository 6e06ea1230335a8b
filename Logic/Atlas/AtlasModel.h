#pragma once
#include <memory>

#include "Logic/Atlas/Atlas.h"
#include "Logic/Atlas/SurfaceCounterparts.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// An atlas made ready for scans: its modes where closest points are sought. Immutable.
class AtlasModel {
 public:
  /// `preop`: the surface that the atlas's mesh fills, same frame. Throws InputError as checkSurface does, or
  /// for an atlas without deformations.
  AtlasModel(const Surface& preop, std::shared_ptr<const Atlas> atlas);

  [[nodiscard]] const Surface& preop() const { return preop_; }
  [[nodiscard]] const Atlas& atlas() const { return *atlas_; }
  /// The pre-op surface, subdivided where its edges are long: closest points are sought among its P points.
  [[nodiscard]] const Surface& fine() const { return fine_; }

  /// 3 x rank: displacement of point `p` of fine() by each mode.
  [[nodiscard]] auto modesAt(Index p) const { return modes_.middleRows<3>(3 * p); }
  /// The same for a place between points.
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic> modesAt(const Counterpart& place) const;
  /// P x 3, mm: fine()'s points moved by sums of modes.
  [[nodiscard]] Points movedPoints(const VectorXd& coefficients) const;
  /// N x 3, mm: displacements of the mesh's nodes.
  [[nodiscard]] Points displacements(const VectorXd& coefficients) const;

 private:
  Surface preop_, fine_;
  std::shared_ptr<const Atlas> atlas_;
  /// 3 P x rank; single precision is a micrometre in 10 mm, half the memory.
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> modes_;
};

}  // namespace falciform
