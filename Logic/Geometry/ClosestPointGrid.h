#pragma once
#include <algorithm>
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
  [[nodiscard]] int closest(const Eigen::Vector3f& query) const {
    const Eigen::Vector3f place = (query - low_) * perMm_;
    const int x = cellOf(place.x(), counts_.x()), y = cellOf(place.y(), counts_.y()),
              z = cellOf(place.z(), counts_.z());
    return nearest_[static_cast<std::size_t>(x + counts_.x() * (y + counts_.y() * z))];
  }
  [[nodiscard]] double cellMm() const { return 1 / perMm_; }

 private:
  static int cellOf(float place, int count) {
    return static_cast<int>(std::clamp(place, 0.0F, static_cast<float>(count - 1)));
  }
  void propagate(const Points& points);

  Eigen::Vector3f low_ = Eigen::Vector3f::Zero();
  float perMm_ = 1;
  Vector3i counts_ = Vector3i::Zero();
  std::vector<int> nearest_;
};

}  // namespace falciform
