#include "Testing/Logic/Segmentation/PaintedCt.h"

#include <random>

namespace falciform::test {

Image paintedCt(const Vector3i& size, const Vector3d& spacingMm, double noiseHu, std::uint64_t seed,
                const std::function<double(const Vector3d&)>& hu) {
  Image ct;
  ct.size = size;
  ct.worldFromIndex.diagonal().head<3>() = spacingMm;
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> noise(0, noiseHu);
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
        ct.voxels.push_back(static_cast<float>(hu(ct.world(Vector3d(i, j, k))) + noise(generator)));
  return ct;
}

double dice(const LabelMap& a, const LabelMap& b) {
  std::size_t both = 0, sum = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i) {
    both += a.voxels[i] > 0 && b.voxels[i] > 0;
    sum += static_cast<std::size_t>(a.voxels[i] > 0) + static_cast<std::size_t>(b.voxels[i] > 0);
  }
  return sum == 0 ? 1 : 2 * static_cast<double>(both) / static_cast<double>(sum);
}

}  // namespace falciform::test
