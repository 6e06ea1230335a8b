#include "Logic/Deformation/Normalisation/FieldSamples.h"

#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/Normalisation/FieldSample.h"

namespace falciform {

FieldSamples samplesOf(const GridField& target, double bandMm, double everyMm) {
  const Vector3d size = (target.counts.array() - 1).cast<double>() * target.cellMm;
  const Vector3i counts = (size / everyMm).array().floor().cast<int>() + 1;
  std::vector<FieldSamples> slices(static_cast<std::size_t>(counts.z()));
  forEachChunk(slices.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z) {
      std::vector<Vector3d> places;
      for (int y = 0; y < counts.y(); ++y)
        for (int x = 0; x < counts.x(); ++x) {
          const Vector3d place = target.origin + everyMm * Vector3d(x, y, static_cast<double>(z));
          const double value = sampleField(target, place).value;
          if (std::abs(value) >= bandMm) continue;
          places.push_back(place);
          slices[z].values.push_back(static_cast<float>(value));
        }
      slices[z].places = Eigen::Map<const Points>(places.empty() ? nullptr : places.front().data(),
                                                  static_cast<Index>(places.size()), 3);
    }
  });
  FieldSamples samples;
  for (const FieldSamples& slice : slices)
    samples.values.insert(samples.values.end(), slice.values.begin(), slice.values.end());
  samples.places.resize(static_cast<Index>(samples.values.size()), 3);
  Index row = 0;
  for (const FieldSamples& slice : slices) {
    samples.places.middleRows(row, slice.places.rows()) = slice.places;
    row += slice.places.rows();
  }
  return samples;
}

}  // namespace falciform
