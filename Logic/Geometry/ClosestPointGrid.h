#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Which of a set's points is about nearest, looked up instead of searched: a voxel map of closest points
/// (Kapoutsis 1999; Cao 2004) over the set's box and a margin. The answer is near the exact one for the
/// cell's centre, so good to about a cell: for searches with many queries, not for the last word. Immutable;
/// any number of threads may ask.
class ClosestPointGrid {
 public:
  ClosestPointGrid() = default;
  /// Over the rows `ids` of `points` (at least one, all finite); the cell is made larger where the map would
  /// exceed 4 million cells.
  ClosestPointGrid(const Points& points, const std::vector<int>& ids, double cellMm, double marginMm);

  /// Row of `points`; a query outside the map asks the map's nearest cell.
  [[nodiscard]] int closest(const Vector3d& query) const {
    const Vector3d place = (query - low_) * perMm_;
    return nearest_[static_cast<std::size_t>(
        cellOf(place.x(), 0) + counts_[0] * (cellOf(place.y(), 1) + counts_[1] * cellOf(place.z(), 2)))];
  }
  [[nodiscard]] double cellMm() const { return 1 / perMm_; }

 private:
  [[nodiscard]] int cellOf(double place, int axis) const {
    return place <= 0 ? 0 : place >= counts_[axis] ? counts_[axis] - 1 : static_cast<int>(place);
  }
  void propagate(const Points& points);

  Vector3d low_ = Vector3d::Zero();
  double perMm_ = 1;
  Vector3i counts_ = Vector3i::Zero();
  std::vector<int> nearest_;
};

}  // namespace falciform
