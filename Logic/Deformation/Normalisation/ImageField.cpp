#include "Logic/Deformation/Normalisation/ImageField.h"

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/VolumeSampling.h"

namespace falciform {

GridField imageField(const Image& image, const Surface& around, double cellMm, double marginMm) {
  constexpr float kAir = -1000;
  const auto box = boundingBox(around.points);
  const Vector3d low = box.row(0).transpose().array() - marginMm,
                 size = (box.row(1) - box.row(0)).transpose().array() + 2 * marginMm;
  GridField field;
  field.cellMm = cellMm;
  field.origin = low;
  field.counts = (size / cellMm).array().ceil().cast<int>() + 1;
  field.values.resize(static_cast<std::size_t>(field.counts.cast<Index>().prod()));
  const Matrix4d indexFromWorld = image.worldFromIndex.inverse();
  const TrilinearVoxels voxels{image};
  const auto rows = static_cast<std::size_t>(field.counts.y()) * static_cast<std::size_t>(field.counts.z());
  forEachChunk(rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row) % field.counts.y(), z = static_cast<int>(row) / field.counts.y();
      for (int x = 0; x < field.counts.x(); ++x) {
        float sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const Vector3d part((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5);
          const Vector3d place = field.place(x, y, z) + 0.5 * cellMm * part;
          sum += voxels((indexFromWorld * place.homogeneous()).head<3>(), kAir);
        }
        field.values[field.index(x, y, z)] = sum / 8;
      }
    }
  });
  return field;
}

}  // namespace falciform
