#include "Logic/Deformation/Normalisation/CarriedImages.h"

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/VolumeSampling.h"

namespace falciform {

namespace {

template <class T, class Sampler>
Volume<T> carry(const DisplacementGrid& carrier, const Volume<T>& source, T background,
                const Sampler& sampler, const Vector3i& size, const Matrix4d& worldFromIndex) {
  const Matrix4d indexFromWorld = source.worldFromIndex.inverse();
  const Matrix4d carrierFromIndex = carrier.worldFromIndex.inverse() * worldFromIndex;
  Volume<T> carried{size, worldFromIndex, {}};
  carried.voxels.resize(static_cast<std::size_t>(size.cast<Index>().prod()));
  const auto rows = static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(size.z());
  forEachChunk(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int j = static_cast<int>(row) % size.y(), k = static_cast<int>(row) / size.y();
      for (int i = 0; i < size.x(); ++i) {
        const Vector3d index(i, j, k);
        const Vector3d in = (carrierFromIndex * index.homogeneous()).head<3>();
        const Vector3d place = carried.world(index) + displacementAt(carrier, in);
        carried.at(i, j, k) = sampler((indexFromWorld * place.homogeneous()).template head<3>(), background);
      }
    }
  });
  return carried;
}

}  // namespace

DisplacementGrid sampleDisplacements(const LiverMap& map, const Vector3i& size,
                                     const Matrix4d& worldFromIndex, const Progress& progress) {
  DisplacementGrid grid{size, worldFromIndex, {}};
  grid.voxels.resize(static_cast<std::size_t>(size.cast<Index>().prod()));
  Points places(static_cast<Index>(size.x()) * size.y(), 3);
  for (int k = 0; k < size.z(); ++k) {
    progress.report(static_cast<double>(k) / size.z(), "Sampling displacements");
    Index row = 0;
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i) places.row(row++) = grid.world(Vector3d(i, j, k)).transpose();
    const Points moved = map.toSource(places) - places;
    for (row = 0; row < moved.rows(); ++row)
      grid.voxels[grid.offset(0, 0, k) + static_cast<std::size_t>(row)] =
          moved.row(row).transpose().cast<float>();
  }
  return grid;
}

Image carryImage(const DisplacementGrid& carrier, const Image& source, float background, const Vector3i& size,
                 const Matrix4d& worldFromIndex) {
  return carry<float>(carrier, source, background, TrilinearVoxels{source}, size, worldFromIndex);
}

LabelMap carryLabels(const DisplacementGrid& carrier, const LabelMap& source, const Vector3i& size,
                     const Matrix4d& worldFromIndex) {
  return carry<std::uint16_t>(carrier, source, 0, NearestVoxel<std::uint16_t>{source}, size, worldFromIndex);
}

}  // namespace falciform
