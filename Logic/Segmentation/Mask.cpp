#include "Logic/Segmentation/Mask.h"

#include <algorithm>
#include <array>

#include "Logic/Segmentation/SurfaceImport.h"

namespace falciform {

namespace {

/// Lowest and highest index of the selected voxels; low > high if there is none.
std::pair<Vector3i, Vector3i> boundsOf(const LabelMap& map, const std::vector<char>& isOrgan) {
  Vector3i low = map.size, high = Vector3i::Constant(-1);
  const auto organ = [&](std::uint16_t value) { return isOrgan[value] != 0; };
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j) {
      const auto begin = map.voxels.begin() + static_cast<std::ptrdiff_t>(map.offset(0, j, k));
      const auto end = begin + map.size.x();
      const auto first = std::find_if(begin, end, organ);
      if (first == end) continue;
      auto last = end - 1;
      while (!organ(*last)) --last;
      low = low.cwiseMin(Vector3i(static_cast<int>(first - begin), j, k));
      high = high.cwiseMax(Vector3i(static_cast<int>(last - begin), j, k));
    }
  return {low, high};
}

LabelMap crop(const LabelMap& map, const Vector3i& low, const Vector3i& high) {
  LabelMap part;
  part.size = high - low + Vector3i::Ones();
  part.worldFromIndex = map.worldFromIndex;
  part.worldFromIndex.topRightCorner<3, 1>() = map.world(low.cast<double>());
  part.voxels.reserve(static_cast<std::size_t>(part.size.cast<Index>().prod()));
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j) {
      const auto row = map.voxels.begin() + static_cast<std::ptrdiff_t>(map.offset(low.x(), j, k));
      part.voxels.insert(part.voxels.end(), row, row + part.size.x());
    }
  return part;
}

std::array<std::ptrdiff_t, 6> neighbourOffsets(const Mask& mask) {
  const std::ptrdiff_t row = mask.size.x(), slice = row * mask.size.y();
  return {-slice, -row, -1, 1, row, slice};
}

/// Gives `now` to all voxels of value `was` that hang together with `seed`; returns how many. The outermost
/// layer must not hold `was`, so that no neighbour lies outside the grid.
std::size_t flood(Mask& mask, std::size_t seed, std::uint8_t was, std::uint8_t now,
                  std::vector<std::size_t>& stack) {
  const auto offsets = neighbourOffsets(mask);
  std::size_t count = 1;
  mask.voxels[seed] = now;
  stack.assign(1, seed);
  while (!stack.empty()) {
    const std::size_t here = stack.back();
    stack.pop_back();
    for (const std::ptrdiff_t offset : offsets) {
      const std::size_t there = here + static_cast<std::size_t>(offset);
      if (mask.voxels[there] != was) continue;
      mask.voxels[there] = now;
      stack.push_back(there);
      ++count;
    }
  }
  return count;
}

/// Visits the outermost layer of voxels.
template <class Visit>
void eachOuterVoxel(const Vector3i& size, Visit&& visit) {
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j) {
      const bool whole = k == 0 || j == 0 || k == size.z() - 1 || j == size.y() - 1;
      for (int i = 0; i < size.x(); i += whole ? 1 : size.x() - 1) visit(i, j, k);
    }
}

}  // namespace

Mask cutOut(const LabelMap& map, const std::vector<char>& isOrgan) {
  const auto [low, high] = boundsOf(map, isOrgan);
  if (high.x() < 0) return {};
  const LabelMap part = canonicalAxes(crop(map, low, high));

  const Vector3i margin = Vector3i::Constant(kMaskMargin);
  Mask mask;
  mask.size = part.size + 2 * margin;
  mask.worldFromIndex = part.worldFromIndex;
  mask.worldFromIndex.topRightCorner<3, 1>() = part.world(-margin.cast<double>());
  mask.voxels.assign(static_cast<std::size_t>(mask.size.cast<Index>().prod()), 0);
  for (int k = 0; k < part.size.z(); ++k)
    for (int j = 0; j < part.size.y(); ++j)
      for (int i = 0; i < part.size.x(); ++i)
        mask.at(i + kMaskMargin, j + kMaskMargin, k + kMaskMargin) = isOrgan[part.at(i, j, k)] != 0;
  return mask;
}

ComponentCounts keepLargestComponent(Mask& mask) {
  constexpr std::uint8_t kSeen = 2, kKept = 3;
  ComponentCounts counts;
  std::vector<std::size_t> stack;
  std::size_t all = 0, largest = 0, seed = 0;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    if (mask.voxels[i] != 1) continue;
    const std::size_t size = flood(mask, i, 1, kSeen, stack);
    ++counts.pieces;
    all += size;
    if (size > largest) {
      largest = size;
      seed = i;
    }
  }
  if (counts.pieces == 0) return counts;
  flood(mask, seed, kSeen, kKept, stack);
  for (std::uint8_t& value : mask.voxels) value = value == kKept;
  counts.droppedVoxels = all - largest;
  return counts;
}

std::size_t fillCavities(Mask& mask) {
  if (mask.voxels.empty()) return 0;
  constexpr std::uint8_t kOutside = 2;
  eachOuterVoxel(mask.size, [&](int i, int j, int k) { mask.at(i, j, k) = kOutside; });
  std::vector<std::size_t> stack;
  flood(mask, mask.offset(1, 1, 1), 0, kOutside, stack);
  std::size_t filled = 0;
  for (std::uint8_t& value : mask.voxels) {
    filled += value == 0;
    value = value != kOutside;
  }
  return filled;
}

std::size_t countOrgan(const Mask& mask) {
  return static_cast<std::size_t>(std::count(mask.voxels.begin(), mask.voxels.end(), std::uint8_t{1}));
}

}  // namespace falciform
