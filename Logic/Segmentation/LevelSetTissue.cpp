#include "Logic/Segmentation/LevelSetTissue.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Segmentation/GridFilters.h"

namespace falciform {

namespace {

double medianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

}  // namespace

Tissue tissueOf(std::vector<float> values) {
  if (values.empty()) return {};
  Tissue tissue;
  tissue.level = medianOf(values);
  for (float& value : values) value = std::abs(value - static_cast<float>(tissue.level));
  tissue.spread = std::max(kLeastSpread, 1.4826 * medianOf(values));
  return tissue;
}

std::vector<float> valuesAround(const Image& image, const Vector3d& index, double radiusMm) {
  const Vector3d spacing = image.spacing();
  Vector3i low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = std::max(0, static_cast<int>(std::ceil(index[a] - radiusMm / spacing[a])));
    high[a] = std::min(image.size[a] - 1, static_cast<int>(std::floor(index[a] + radiusMm / spacing[a])));
  }
  std::vector<float> values;
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i)
        if ((Vector3d(i, j, k) - index).cwiseProduct(spacing).norm() <= radiusMm)
          values.push_back(image.at(i, j, k));
  return values;
}

std::vector<float> valuesIn(const Image& image, const Volume<std::uint8_t>& flags) {
  std::vector<float> values;
  for (std::size_t i = 0; i < flags.voxels.size(); ++i)
    if (flags.voxels[i] != 0) values.push_back(image.voxels[i]);
  return values;
}

Image membership(const Image& image, const Tissue& tissue, double width, double smoothingMm) {
  Image member = image;
  const auto level = static_cast<float>(tissue.level), half = static_cast<float>(width * tissue.spread);
  forEachChunk(member.voxels.size(), 65536, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float u = (image.voxels[i] - level) / half, square = u * u, fourth = square * square;
      member.voxels[i] = 1 / (1 + fourth * fourth);
    }
  });
  smooth(member, smoothingMm);
  return member;
}

}  // namespace falciform
