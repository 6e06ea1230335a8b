#pragma once
#include <algorithm>
#include <cmath>

#include "Logic/Geometry/GridField.h"

namespace falciform {

struct FieldSample {
  double value = 0;
  Vector3d slope = Vector3d::Zero();  ///< per mm
};

/// The field between its corners, trilinear, with its slope; beyond the lattice the value of the nearest
/// border place and no slope.
[[nodiscard]] inline FieldSample sampleField(const GridField& field, const Vector3d& place) {
  const Vector3d at = (place - field.origin) / field.cellMm;
  const Vector3d held = at.cwiseMax(0.0).cwiseMin((field.counts.array() - 1).cast<double>().matrix());
  const Vector3i cell = held.array().floor().cast<int>().min(field.counts.array() - 2).max(0);
  const Vector3d w = held - cell.cast<double>();
  const float* v = field.values.data() + field.index(cell.x(), cell.y(), cell.z());
  const auto dy = static_cast<std::size_t>(field.counts.x()),
             dz = dy * static_cast<std::size_t>(field.counts.y());
  const double x00 = v[1] - v[0], x10 = v[dy + 1] - v[dy], x01 = v[dz + 1] - v[dz],
               x11 = v[dz + dy + 1] - v[dz + dy];
  const double v00 = v[0] + w.x() * x00, v10 = v[dy] + w.x() * x10, v01 = v[dz] + w.x() * x01,
               v11 = v[dz + dy] + w.x() * x11;
  const double v0 = v00 + w.y() * (v10 - v00), v1 = v01 + w.y() * (v11 - v01);
  FieldSample sample;
  sample.value = v0 + w.z() * (v1 - v0);
  if (held != at) return sample;
  sample.slope =
      Vector3d((1 - w.z()) * ((1 - w.y()) * x00 + w.y() * x10) + w.z() * ((1 - w.y()) * x01 + w.y() * x11),
               (1 - w.z()) * (v10 - v00) + w.z() * (v11 - v01), v1 - v0) /
      field.cellMm;
  return sample;
}

}  // namespace falciform
