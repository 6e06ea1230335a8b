#pragma once
#include <vector>

namespace falciform {

/// An elimination forest cut for parallel work: the branches stand apart from each other, the trunk is above
/// them. The cut depends on the forest alone, so what is computed along it does not depend on the number of
/// threads.
struct ForestCut {
  std::vector<std::vector<int>>
      branches;            ///< heaviest first; each ascending, so children stand before parents
  std::vector<int> trunk;  ///< ascending
};

/// Cuts the forest given by `parents` (each above its child in number, -1 at roots) by the work at every
/// node: the heaviest subtree is opened until there are `branches` of them.
[[nodiscard]] ForestCut cutForest(const std::vector<int>& parents, const std::vector<double>& work,
                                  std::size_t branches);

}  // namespace falciform
