#include "Testing/Logic/IO/SurfaceSamples.h"

#include <random>

#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

Surface fullSurface() {
  Surface surface = lumpyBody(2);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  surface.normals = Points::NullaryExpr(surface.size(), 3, [&] { return uniform(random); });
  surface.normals.rowwise().normalize();
  surface.colours =
      Colours::NullaryExpr(surface.size(), 3, [&] { return static_cast<std::uint8_t>(random() % 256); });
  surface.arrays["signed_distance_mm"] =
      VectorXd::NullaryExpr(surface.size(), [&] { return uniform(random); });
  surface.arrays["mean_curvature_per_mm"] =
      VectorXd::NullaryExpr(surface.size(), [&] { return uniform(random); });
  surface.patch[5] = 3;
  surface.patch[6] = 255;
  surface.patchNames = {{3, "gallbladder fossa"}, {255, "Lebervene, links = \u00fc"}};
  return surface;
}

}  // namespace falciform::test
