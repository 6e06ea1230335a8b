#include "Logic/Atlas/DesignSampling.h"

#include <numeric>
#include <utility>
#include <vector>

#include "Logic/Core/Draws.h"

namespace falciform {

Eigen::MatrixXd latinHypercube(int count, int dimensions, std::uint64_t seed, std::uint64_t stream) {
  Draws draws(seed, stream);
  Eigen::MatrixXd points(count, dimensions);
  std::vector<int> slices(static_cast<std::size_t>(count));
  for (int axis = 0; axis < dimensions; ++axis) {
    std::iota(slices.begin(), slices.end(), 0);
    for (int k = count - 1; k > 0; --k)
      std::swap(slices[static_cast<std::size_t>(k)],
                slices[static_cast<std::size_t>(draws.uniform() * (k + 1))]);
    for (int k = 0; k < count; ++k)
      points(k, axis) = (slices[static_cast<std::size_t>(k)] + draws.uniform()) / count;
  }
  return points;
}

}  // namespace falciform
