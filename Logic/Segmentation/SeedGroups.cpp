#include "Logic/Segmentation/SeedGroups.h"

#include <algorithm>
#include <cmath>

namespace falciform {

namespace {

/// HU: seeds of one organ may differ by so much, noise or not.
constexpr double kAlikeHu = 20;

bool alike(const Tissue& a, const Tissue& b) {
  return std::abs(a.level - b.level) <= std::max(kAlikeHu, 3 * std::max(a.spread, b.spread));
}

}  // namespace

std::vector<SeedGroup> groupSeeds(const Image& image, const std::vector<Vector3d>& seeds, double radiusMm,
                                  const Tissue* known) {
  std::vector<SeedGroup> groups;
  std::vector<std::vector<float>> values;
  if (known != nullptr) {
    groups.push_back({*known, {}, {}});
    values.emplace_back();
  }
  for (std::size_t s = 0; s < seeds.size(); ++s) {
    const std::vector<float> around = valuesAround(image, seeds[s], radiusMm);
    const Tissue here = tissueOf(around);
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const SeedGroup& g) { return alike(g.tissue, here); });
    if (group == groups.end()) {
      group = groups.insert(groups.end(), SeedGroup{here, {}, {}});
      values.emplace_back();
    }
    group->seeds.push_back(seeds[s]);
    group->numbers.push_back(static_cast<Index>(s));
    auto& pooled = values[static_cast<std::size_t>(group - groups.begin())];
    pooled.insert(pooled.end(), around.begin(), around.end());
    if (known == nullptr || group != groups.begin()) group->tissue = tissueOf(pooled);
  }
  // What is unlike the organ need not hang together: each such seed stands for itself.
  std::vector<SeedGroup> apart;
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (g == 0) {
      apart.push_back(groups[g]);
    } else {
      for (std::size_t s = 0; s < groups[g].seeds.size(); ++s)
        apart.push_back({groups[g].tissue, {groups[g].seeds[s]}, {groups[g].numbers[s]}});
    }
  return apart;
}

}  // namespace falciform
