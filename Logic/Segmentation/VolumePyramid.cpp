#include "Logic/Segmentation/VolumePyramid.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {
constexpr double kAirHu = -1024;
}

std::vector<Vector3i> pyramidFactors(const Vector3d& spacing, double coarsestMm) {
  std::vector<Vector3i> factors{Vector3i::Ones()};
  for (double target = 2 * spacing.minCoeff(); target <= coarsestMm; target *= 2) {
    Vector3i factor;
    for (int axis = 0; axis < 3; ++axis)
      factor[axis] = std::max(1, static_cast<int>(std::lround(target / spacing[axis])));
    factors.insert(factors.begin(), factor);
  }
  return factors;
}

namespace {

/// Calls `voxel(i, j, k, from, to)` for every voxel of a level, with the turned indices from..to-1 of its
/// block.
template <class Visit>
void eachBlock(const PyramidLevel& level, const Visit& visit) {
  const Vector3i size = level.image.size;
  forEachChunk(static_cast<std::size_t>(size.z()), 1, [&](std::size_t begin, std::size_t end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i) {
          const Vector3i from = level.origin + Vector3i(i, j, k).cwiseProduct(level.factor);
          visit(level.image.offset(i, j, k), from, from + level.factor);
        }
  });
}

}  // namespace

PyramidLevel coarsened(const Image& ct, const StorageOrder& order, const Vector3i& factor,
                       const Vector3i& low, const Vector3i& high) {
  PyramidLevel level{factor, low, {}};
  Image& image = level.image;
  for (int axis = 0; axis < 3; ++axis) {
    image.size[axis] = (high[axis] - low[axis]) / factor[axis] + 1;
    image.worldFromIndex.col(axis) = order.worldFromIndex.col(axis) * factor[axis];
  }
  const Vector3d centre = level.toStored(Vector3d::Zero());
  image.worldFromIndex.col(3) = order.worldFromIndex * centre.homogeneous();
  image.voxels.resize(static_cast<std::size_t>(image.size.cast<Index>().prod()));
  const Vector3i last = order.size - Vector3i::Ones();
  eachBlock(level, [&](std::size_t voxel, const Vector3i& from, const Vector3i& to) {
    double sum = 0;
    for (int z = from.z(); z < to.z(); ++z)
      for (int y = from.y(); y < to.y(); ++y)
        for (int x = from.x(); x < to.x(); ++x) {
          const float value = ct.voxels[order.offset(std::clamp(x, 0, last.x()), std::clamp(y, 0, last.y()),
                                                     std::clamp(z, 0, last.z()))];
          sum += std::isfinite(value) ? static_cast<double>(value) : kAirHu;
        }
    image.voxels[voxel] = static_cast<float>(sum / factor.prod());
  });
  return level;
}

Image coarsenedShare(const LabelMap& map, const StorageOrder& order, const PyramidLevel& like) {
  Image share{like.image.size, like.image.worldFromIndex, std::vector<float>(like.image.voxels.size(), 0)};
  eachBlock(like, [&](std::size_t voxel, const Vector3i& from, const Vector3i& to) {
    const Vector3i low = from.cwiseMax(0), high = to.cwiseMin(order.size);
    int count = 0;
    for (int z = low.z(); z < high.z(); ++z)
      for (int y = low.y(); y < high.y(); ++y)
        for (int x = low.x(); x < high.x(); ++x) count += map.voxels[order.offset(x, y, z)] > 0;
    share.voxels[voxel] = static_cast<float>(count) / static_cast<float>(like.factor.prod());
  });
  return share;
}

Image resampled(const Image& image, const PyramidLevel& from, const PyramidLevel& to,
                const Volume<std::uint8_t>* skip) {
  Image result{to.image.size, to.image.worldFromIndex, std::vector<float>(to.image.voxels.size(), 0)};
  forEachChunk(static_cast<std::size_t>(result.size.z()), 1, [&](std::size_t begin, std::size_t end) {
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
      for (int j = 0; j < result.size.y(); ++j)
        for (int i = 0; i < result.size.x(); ++i)
          if (skip == nullptr || skip->at(i, j, k) == 0)
            result.at(i, j, k) = valueAt(image, from.fromStored(to.toStored(Vector3d(i, j, k))));
  });
  return result;
}

float valueAt(const Image& image, const Vector3d& index) {
  Vector3i low;
  Vector3d share;
  for (int a = 0; a < 3; ++a) {
    const double at = std::clamp(index[a], 0.0, static_cast<double>(image.size[a] - 1));
    low[a] = std::min(static_cast<int>(at), std::max(0, image.size[a] - 2));
    share[a] = at - low[a];
  }
  const Vector3i high = (low + Vector3i::Ones()).cwiseMin(image.size - Vector3i::Ones());
  const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
  const auto row = [&](int j, int k) {
    return mix(static_cast<double>(image.at(low.x(), j, k)), static_cast<double>(image.at(high.x(), j, k)),
               share.x());
  };
  return static_cast<float>(mix(mix(row(low.y(), low.z()), row(high.y(), low.z()), share.y()),
                                mix(row(low.y(), high.z()), row(high.y(), high.z()), share.y()), share.z()));
}

}  // namespace falciform
