#include "Logic/Biomechanics/EliminationForest.h"

#include <algorithm>
#include <queue>

namespace falciform {

ForestCut cutForest(const std::vector<int>& parents, const std::vector<double>& work, std::size_t branches) {
  const std::size_t count = parents.size();
  std::vector<double> weight = work;
  std::vector<std::vector<int>> children(count);
  for (std::size_t p = 0; p < count; ++p) {
    if (parents[p] < 0) continue;
    weight[static_cast<std::size_t>(parents[p])] += weight[p];
    children[static_cast<std::size_t>(parents[p])].push_back(static_cast<int>(p));
  }
  std::priority_queue<std::pair<double, int>> heaviest;
  for (std::size_t p = 0; p < count; ++p)
    if (parents[p] < 0) heaviest.emplace(weight[p], static_cast<int>(p));
  ForestCut cut;
  while (!heaviest.empty() && heaviest.size() < branches) {
    const int top = heaviest.top().second;
    heaviest.pop();
    cut.trunk.push_back(top);
    for (const int child : children[static_cast<std::size_t>(top)])
      heaviest.emplace(weight[static_cast<std::size_t>(child)], child);
  }
  std::sort(cut.trunk.begin(), cut.trunk.end());
  for (; !heaviest.empty(); heaviest.pop()) {
    std::vector<int> branch{heaviest.top().second};
    for (std::size_t k = 0; k < branch.size(); ++k)
      for (const int child : children[static_cast<std::size_t>(branch[k])]) branch.push_back(child);
    std::sort(branch.begin(), branch.end());
    cut.branches.push_back(std::move(branch));
  }
  return cut;
}

}  // namespace falciform
