#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/Normalisation/FieldSample.h"
#include "Logic/Deformation/Normalisation/Similarity.h"

namespace falciform {

double DistanceSimilarity::linearise(const Points& places, std::vector<float>& off,
                                     std::vector<Row>& slope) const {
  constexpr std::size_t kChunk = 2048;
  const std::size_t count = wanted_.size();
  off.resize(count);
  slope.resize(count);
  std::vector<double> squares(count / kChunk + 1, 0.0);
  forEachChunk(count, kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FieldSample sample = sampleField(source_, places.row(static_cast<Index>(i)).transpose());
      off[i] = static_cast<float>(std::clamp(sample.value, -band_, band_) -
                                  std::clamp<double>(wanted_[i], -band_, band_));
      slope[i].setZero();
      if (std::abs(sample.value) < band_) slope[i].head<3>() = sample.slope.cast<float>();
      squares[begin / kChunk] += double(off[i]) * off[i];
    }
  });
  double sum = 0;
  for (const double part : squares) sum += part;
  return sum;
}

}  // namespace falciform
