#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Places of a tracked tool's tip in the order in which they were taken: single points touched with a stylus,
/// or swabs, where the tip is drawn over the organ while the tracker records.
struct TrackedPoints {
  Points points;                     ///< N x 3, mm, in `frame`
  std::vector<int> stroke;           ///< N, from 0, ascending: points of one stroke were taken in one go
  VectorXd seconds;                  ///< N, ascending, or 0 rows where the file keeps no time
  std::vector<std::string> strokes;  ///< the strokes' names
  int lost = 0;                      ///< samples that the tracker itself declared missing or bad
  std::string frame = "tracker";

  [[nodiscard]] Index size() const { return points.rows(); }
};

}  // namespace falciform
