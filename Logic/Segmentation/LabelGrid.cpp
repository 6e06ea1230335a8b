#include "Logic/Segmentation/StorageOrder.h"
#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {

std::vector<std::pair<int, std::size_t>> labelCounts(const LabelMap& map) {
  std::vector<std::size_t> counts(65536, 0);
  for (const std::uint16_t value : map.voxels) ++counts[value];
  std::vector<std::pair<int, std::size_t>> found;
  for (int value = 1; value < 65536; ++value)
    if (counts[static_cast<std::size_t>(value)] > 0)
      found.emplace_back(value, counts[static_cast<std::size_t>(value)]);
  return found;
}

LabelMap canonicalAxes(const LabelMap& map) {
  const StorageOrder order = canonicalOrder(map.size, map.worldFromIndex);
  LabelMap turned;
  turned.size = order.size;
  turned.worldFromIndex = order.worldFromIndex;
  turned.voxels.reserve(map.voxels.size());
  for (int k = 0; k < turned.size.z(); ++k)
    for (int j = 0; j < turned.size.y(); ++j)
      for (int i = 0; i < turned.size.x(); ++i) turned.voxels.push_back(map.voxels[order.offset(i, j, k)]);
  return turned;
}

}  // namespace falciform
