#include "Logic/Segmentation/FrontPreview.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/VolumeSampling.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {
namespace {

constexpr double kSketchMm = 4;  ///< voxel of the light surface
constexpr int kSmoothing = 10;
constexpr double kPassBand = 0.1;

/// Shares of blocks of whole voxels near `kSketchMm`, with an empty block all around so that the surface
/// closes.
Image blockShares(const Mask& front) {
  const Vector3d spacing = front.spacing();
  const Vector3i factor = (kSketchMm / spacing.array()).round().cast<int>().matrix().cwiseMax(1);
  Image shares;
  shares.size =
      ((front.size + factor - Vector3i::Ones()).array() / factor.array()).matrix() + 2 * Vector3i::Ones();
  shares.worldFromIndex = front.worldFromIndex;
  for (int a = 0; a < 3; ++a) shares.worldFromIndex.col(a) *= factor[a];
  // The middle of block 0 is half a block from the edge of voxel 0; index 1 here.
  const Vector3d first = 0.5 * (factor - Vector3i::Ones()).cast<double>() - factor.cast<double>();
  shares.worldFromIndex.topRightCorner<3, 1>() = front.world(first);
  shares.voxels.assign(static_cast<std::size_t>(shares.size.cast<Index>().prod()), 0);
  const float part = 1.0F / static_cast<float>(factor.prod());
  for (int k = 0; k < front.size.z(); ++k)
    for (int j = 0; j < front.size.y(); ++j) {
      const std::size_t row = front.offset(0, j, k);
      float* blocks = &shares.at(1, j / factor.y() + 1, k / factor.z() + 1);
      for (int i = 0; i < front.size.x(); ++i)
        if (front.voxels[row + static_cast<std::size_t>(i)] != 0) blocks[i / factor.x()] += part;
    }
  return shares;
}

/// Lowest and one past the highest index of `ct` that the grid of `front` can reach.
std::pair<Vector3i, Vector3i> reachOf(const LabelMap& front, const Image& ct) {
  const Matrix4d ctFromFront = ct.worldFromIndex.inverse() * front.worldFromIndex;
  Vector3d low = Vector3d::Constant(1e9), high = Vector3d::Constant(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    Vector3d index;
    for (int a = 0; a < 3; ++a) index[a] = (corner >> a) & 1 ? front.size[a] : -1;
    const Vector3d at = (ctFromFront * index.homogeneous()).head<3>();
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  return {low.array().floor().cast<int>().matrix().cwiseMax(0),
          (high.array().ceil().cast<int>() + 1).matrix().cwiseMin(ct.size)};
}

}  // namespace

FrontPreview previewOf(const Mask& front) {
  FrontPreview preview;
  preview.labels.size = front.size;
  preview.labels.worldFromIndex = front.worldFromIndex;
  preview.labels.voxels.assign(front.voxels.begin(), front.voxels.end());
  const Image shares = blockShares(front);
  if (std::any_of(shares.voxels.begin(), shares.voxels.end(), [](float share) { return share > 0.5F; }))
    preview.surface = smoothWindowedSinc(isosurface(shares, 0.5), kSmoothing, kPassBand);
  return preview;
}

LabelMap onGridOf(const Image& ct, const LabelMap& front) {
  LabelMap labels{ct.size, ct.worldFromIndex, std::vector<std::uint16_t>(ct.voxels.size(), 0)};
  if (front.voxels.empty()) return labels;
  const auto [low, high] = reachOf(front, ct);
  if ((high - low).minCoeff() <= 0) return labels;
  const Matrix4d frontFromCt = front.worldFromIndex.inverse() * ct.worldFromIndex;
  // A front cut off by the volume's border goes on to it: beyond its grid the nearest voxels count.
  const Image shares{front.size, front.worldFromIndex, {front.voxels.begin(), front.voxels.end()}};
  const TrilinearVoxels shareAt{shares};
  forEachChunk(static_cast<std::size_t>(high.z() - low.z()), 1,
               [&, low = low, high = high](std::size_t begin, std::size_t) {
                 const int k = low.z() + static_cast<int>(begin);
                 for (int j = low.y(); j < high.y(); ++j)
                   for (int i = low.x(); i < high.x(); ++i) {
                     const Vector3d index = (frontFromCt * Eigen::Vector4d(i, j, k, 1)).head<3>();
                     labels.at(i, j, k) = shareAt(index, 0) > 0.5F;
                   }
               });
  return labels;
}

}  // namespace falciform
