#pragma once
#include <vector>

#include "Logic/Registration/Trials/Trials.h"

namespace falciform {

/// Those of N x 3 points that lie farthest out in one of `directions` directions spread over the sphere. A
/// rigid motion moves a hull vertex most, so these few tell how far two poses place a body apart.
[[nodiscard]] Points outermostPoints(const Points& points, int directions = 256);

/// The pose that each record ended in, from 1: poses that place all `outermost` points within `withinMm` of
/// each other's first, best-fitting member are one. 1 is the commonest over all methods.
[[nodiscard]] std::vector<int> trialBasins(const std::vector<TrialRecord>& records, const Points& outermost,
                                           double withinMm);

}  // namespace falciform
