#include "Logic/Segmentation/GridFilters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Takes each line along `axis` out, hands it to `change(line, scratch)` and puts it back.
template <class Change>
void eachLine(Image& image, int axis, const Change& change) {
  const std::ptrdiff_t stride[3] = {1, image.size.x(),
                                    static_cast<std::ptrdiff_t>(image.size.x()) * image.size.y()};
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2, length = image.size[axis];
  const auto lines = static_cast<std::size_t>(image.size[u]) * static_cast<std::size_t>(image.size[v]);
  forEachChunk(lines, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<float> line(static_cast<std::size_t>(length)), scratch(line.size());
    for (std::size_t n = begin; n < end; ++n) {
      const auto across = static_cast<std::ptrdiff_t>(n) % image.size[u],
                 along = static_cast<std::ptrdiff_t>(n) / image.size[u];
      float* at = image.voxels.data() + across * stride[u] + along * stride[v];
      for (int i = 0; i < length; ++i) line[static_cast<std::size_t>(i)] = at[i * stride[axis]];
      change(line, scratch);
      for (int i = 0; i < length; ++i) at[i * stride[axis]] = line[static_cast<std::size_t>(i)];
    }
  });
}

/// Lower envelope of the parabolas of one line; `step` is the line's spacing.
void distanceLine(std::vector<float>& squared, std::vector<float>& result, double step) {
  const int n = static_cast<int>(squared.size());
  std::vector<int> apex(squared.size());
  std::vector<double> from(squared.size() + 1);
  int top = -1;
  for (int i = 0; i < n; ++i) {
    const double f = static_cast<double>(squared[static_cast<std::size_t>(i)]);
    if (std::isinf(f)) continue;
    double cross = -std::numeric_limits<double>::infinity();
    for (; top >= 0; --top) {
      const int j = apex[static_cast<std::size_t>(top)];
      const double g = static_cast<double>(squared[static_cast<std::size_t>(j)]);
      cross = ((f - g) / (step * step) + static_cast<double>(i) * i - static_cast<double>(j) * j) /
              (2.0 * (i - j));
      if (cross > from[static_cast<std::size_t>(top)]) break;
    }
    if (top < 0) cross = -std::numeric_limits<double>::infinity();
    apex[static_cast<std::size_t>(++top)] = i;
    from[static_cast<std::size_t>(top)] = cross;
  }
  if (top < 0) return;
  for (int i = 0, k = 0; i < n; ++i) {
    while (k < top && from[static_cast<std::size_t>(k) + 1] < i) ++k;
    const int j = apex[static_cast<std::size_t>(k)];
    result[static_cast<std::size_t>(i)] =
        static_cast<float>(step * step * (i - j) * (i - j)) + squared[static_cast<std::size_t>(j)];
  }
  squared.swap(result);
}

}  // namespace

void smooth(Image& image, double sigmaMm) {
  if (!(sigmaMm > 0)) return;
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = sigmaMm / image.spacing()[axis];
    const int half = static_cast<int>(std::ceil(3 * sigma));
    if (half == 0 || sigma < 0.2) continue;
    std::vector<float> weight(static_cast<std::size_t>(half) + 1);
    double sum = 0;
    for (int i = 0; i <= half; ++i) {
      weight[static_cast<std::size_t>(i)] = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)));
      sum += (i == 0 ? 1 : 2) * static_cast<double>(weight[static_cast<std::size_t>(i)]);
    }
    for (float& w : weight) w /= static_cast<float>(sum);
    eachLine(image, axis, [&](std::vector<float>& line, std::vector<float>& result) {
      const int n = static_cast<int>(line.size());
      for (int i = 0; i < n; ++i) {
        float value = weight[0] * line[static_cast<std::size_t>(i)];
        for (int d = 1; d <= half; ++d)
          value +=
              weight[static_cast<std::size_t>(d)] * (line[static_cast<std::size_t>(std::max(0, i - d))] +
                                                     line[static_cast<std::size_t>(std::min(n - 1, i + d))]);
        result[static_cast<std::size_t>(i)] = value;
      }
      line.swap(result);
    });
  }
}

void sumOverBox(Image& image, const Vector3i& half) {
  for (int axis = 0; axis < 3; ++axis)
    eachLine(image, axis, [&](std::vector<float>& line, std::vector<float>& result) {
      const int n = static_cast<int>(line.size()), h = half[axis];
      double sum = 0;
      for (int i = 0; i < std::min(n, h); ++i) sum += static_cast<double>(line[static_cast<std::size_t>(i)]);
      for (int i = 0; i < n; ++i) {
        if (i + h < n) sum += static_cast<double>(line[static_cast<std::size_t>(i + h)]);
        if (i - h - 1 >= 0) sum -= static_cast<double>(line[static_cast<std::size_t>(i - h - 1)]);
        result[static_cast<std::size_t>(i)] = static_cast<float>(sum);
      }
      line.swap(result);
    });
}

Image distanceTo(const Volume<std::uint8_t>& flags) {
  Image distance = sameGrid(flags, kFar);
  for (std::size_t i = 0; i < flags.voxels.size(); ++i)
    if (flags.voxels[i] != 0) distance.voxels[i] = 0;
  const Vector3d spacing = flags.spacing();
  for (int axis = 0; axis < 3; ++axis)
    eachLine(distance, axis, [&](std::vector<float>& line, std::vector<float>& result) {
      distanceLine(line, result, spacing[axis]);
    });
  for (float& value : distance.voxels) value = std::sqrt(value);
  return distance;
}

Image depthWithin(const Volume<std::uint8_t>& flags) {
  Volume<std::uint8_t> outside = flags;
  for (std::uint8_t& value : outside.voxels) value = value == 0;
  return distanceTo(outside);
}

}  // namespace falciform
