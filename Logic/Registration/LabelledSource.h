#pragma once
#include <map>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// The moving side of a registration: N x 3 points in their own frame and N labels (0: none).
struct LabelledSource {
  Points points;
  std::vector<int> labels;
};

/// Rows `ids` of `source`.
[[nodiscard]] LabelledSource subsetOf(const LabelledSource& source, const std::vector<int>& ids);

/// The mean place of each label above 0, mm. `labels`: one a point, or none at all.
[[nodiscard]] std::map<int, Vector3d> centroidsByLabel(const Points& points, const std::vector<int>& labels);

/// `count` rows out of `rows` that are spread at random, the same at every call; all if there are fewer.
[[nodiscard]] std::vector<int> randomRows(Index rows, Index count);

/// Corners of the points' box: the point that moves farthest under a rigid step moves no farther than one of
/// them.
[[nodiscard]] Points boxCorners(const Points& points);

}  // namespace falciform
