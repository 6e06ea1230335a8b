#include "Logic/Atlas/BentImages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "Logic/Atlas/BentBlocks.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/VolumeSampling.h"

namespace falciform {
namespace {

constexpr double kGridToleranceMm = 1e-4, kAroundSpacingMm = 3;

/// Calls body(j, k) for every row of a grid, on all threads; reports from the caller's.
void forEachRow(const Vector3i& size, const Progress& progress, const char* stage,
                const std::function<void(int j, int k)>& body) {
  constexpr int kSlab = 8;  // slices between two reports
  for (int first = 0; first < size.z(); first += kSlab) {
    progress.report(static_cast<double>(first) / size.z(), stage);
    const auto rows =
        static_cast<std::size_t>(std::min(kSlab, size.z() - first)) * static_cast<std::size_t>(size.y());
    forEachChunk(rows, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) {
        const auto ny = static_cast<std::size_t>(size.y());
        body(static_cast<int>(row % ny), first + static_cast<int>(row / ny));
      }
    });
  }
}

template <class T, class Sampler>
Volume<T> bendVolume(const UpdateMap& map, const Volume<T>& volume, T background, const Sampler& sampler,
                     const Progress& progress) {
  const SampledGrid grid = gridAroundLiver(map, volume.size, volume.worldFromIndex);
  const SampledGrid coarse = coarserGrid(grid.size, grid.worldFromIndex, kAroundSpacingMm);
  const DisplacementGrid around =
      sampleDisplacements(map, coarse.size, coarse.worldFromIndex, progress.part(0, 0.4));
  const BentBlocks blocks(map, coarse);
  const Matrix4d indexFromWorld = volume.worldFromIndex.inverse();
  const Matrix4d coarseFromIndex = coarse.worldFromIndex.inverse() * grid.worldFromIndex;
  Volume<T> bent{grid.size, grid.worldFromIndex, {}};
  bent.voxels.resize(static_cast<std::size_t>(grid.size.cast<Index>().prod()));
  forEachRow(grid.size, progress.part(0.4, 1), "Bending the volume", [&](int j, int k) {
    int guess = -1;
    for (int i = 0; i < grid.size.x(); ++i) {
      const Vector3d index(i, j, k), now = bent.world(index);
      const Vector3d inCoarse = (coarseFromIndex * index.homogeneous()).head<3>();
      std::optional<DeformedMesh::Tissue> tissue;
      if (blocks.mayHold(inCoarse)) tissue = map.deformed().find(now, guess);
      if (tissue) guess = tissue->element;
      const Vector3d before = tissue ? tissue->before : Vector3d(now + displacementAt(around, inCoarse));
      bent.at(i, j, k) = sampler((indexFromWorld * before.homogeneous()).template head<3>(), background);
    }
  });
  return bent;
}

}  // namespace

DisplacementGrid sampleDisplacements(const UpdateMap& map, const Vector3i& size,
                                     const Matrix4d& worldFromIndex, const Progress& progress) {
  DisplacementGrid grid{size, worldFromIndex, {}};
  grid.voxels.resize(static_cast<std::size_t>(size.cast<Index>().prod()));
  forEachRow(size, progress, "Sampling displacements", [&](int j, int k) {
    PreopPlace guess;  // the neighbour's displacement is a good start
    Vector3d moved = Vector3d::Zero();
    for (int i = 0; i < size.x(); ++i) {
      const Vector3d now = grid.world(Vector3d(i, j, k));
      guess.preop = now + moved;
      guess = map.preopFromBent(now, i > 0 ? &guess : nullptr, kGridToleranceMm);
      moved = guess.preop - now;
      grid.at(i, j, k) = moved.cast<float>();
    }
  });
  return grid;
}

SampledGrid coarserGrid(const Vector3i& size, const Matrix4d& worldFromIndex, double spacingMm) {
  SampledGrid grid{size, worldFromIndex};
  for (int axis = 0; axis < 3; ++axis) {
    const double step = std::max(1.0, std::round(spacingMm / worldFromIndex.col(axis).head<3>().norm()));
    grid.size[axis] = static_cast<int>(std::ceil((size[axis] - 1) / step)) + 1;
    grid.worldFromIndex.col(axis) *= step;
  }
  return grid;
}

SampledGrid gridAroundLiver(const UpdateMap& map, const Vector3i& size, const Matrix4d& worldFromIndex) {
  const Matrix4d indexFromWorld = worldFromIndex.inverse();
  Vector3d low = Vector3d::Constant(1e30), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    Vector3d place;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] =
          (corner >> axis & 1) != 0 ? map.deformed().highest()[axis] : map.deformed().lowest()[axis];
    const Vector3d index = (indexFromWorld * place.homogeneous()).head<3>();
    low = low.cwiseMin(index);
    high = high.cwiseMax(index);
  }
  SampledGrid grid{size, worldFromIndex};
  for (int axis = 0; axis < 3; ++axis) {
    // No more than doubled on a side: a liver that is not in its CT is the caller's mistake.
    const int before = std::clamp(static_cast<int>(std::ceil(-low[axis])), 0, size[axis]);
    const int after = std::clamp(static_cast<int>(std::ceil(high[axis])) - size[axis] + 1, 0, size[axis]);
    grid.size[axis] += before + after;
    grid.worldFromIndex.col(3) -= before * worldFromIndex.col(axis);
  }
  return grid;
}

float backgroundOf(const Image& ct) {
  float least = 0;
  bool any = false;
  for (const float value : ct.voxels)
    if (std::isfinite(value) && (!any || value < least)) {
      least = value;
      any = true;
    }
  return least;
}

Image bendImage(const UpdateMap& map, const Image& ct, float background, const Progress& progress) {
  return bendVolume(map, ct, background, TrilinearVoxels{ct}, progress);
}

LabelMap bendLabels(const UpdateMap& map, const LabelMap& labels, const Progress& progress) {
  return bendVolume<std::uint16_t>(map, labels, 0, NearestVoxel<std::uint16_t>{labels}, progress);
}

}  // namespace falciform
