#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Biomechanics/MeshPlaces.h"

namespace falciform {

/// How a displacement field goes on outside its mesh.
struct ContinuationPlan {
  double bandMm = 10;  ///< within it the mesh's own field, continued linearly, fades into the smooth one
  double leastMarginMm = 30;  ///< beyond the margin nothing is displaced
  double marginPerMm = 2;     ///< the margin is this many times the largest displacement, if that is more
};

/// The smooth part of it, on a lattice: the mean of the boundary's displacements, weighted by area /
/// (distance^2 + band^2)^2, brought to 0 over the margin by the cubic 1 - 3t^2 + 2t^3. The slope of the taper
/// is at most 1.5 / marginPerMm per mm of displacement, so that it does not fold space over.
class FieldContinuation {
 public:
  FieldContinuation(const MeshLocator& locator, const Points& displacements, const ContinuationPlan& plan);

  struct Value {
    Vector3d displacement = Vector3d::Zero();
    bool near = false;  ///< the place may lie in the mesh or within the band
  };
  [[nodiscard]] Value at(const Vector3d& place) const;
  [[nodiscard]] double marginMm() const { return marginMm_; }

 private:
  [[nodiscard]] std::size_t index(const Vector3i& node) const;

  double marginMm_ = 0, cellMm_ = 1;
  Vector3d origin_ = Vector3d::Zero();
  Vector3i counts_ = Vector3i::Zero();
  std::vector<Vector3d> values_;  ///< of the lattice's nodes, x fastest
  std::vector<std::uint8_t> nearBand_;
};

}  // namespace falciform
