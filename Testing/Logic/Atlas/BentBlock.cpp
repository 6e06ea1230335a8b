#include "Testing/Logic/Atlas/BentBlock.h"

#include <cmath>

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Draws.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::test {

Vector3d bending(const Vector3d& place, double largestMm) {
  const double x = place.x() / 120, y = place.y() / 80, z = place.z() / 50;
  return largestMm * Vector3d(0.3 * std::sin(2 * y), 0.4 * x * z, x * x + 0.2 * std::cos(3 * y) * x);
}

BentBlock bentBlock(bool quadratic, double largestMm) {
  BentBlock made{shakenBlockMesh({120, 80, 50}, {6, 5, 4}, 0.15, 3), {}};
  if (quadratic) made.mesh = quadraticMesh(made.mesh);
  made.displacements.resize(made.mesh.nodes(), 3);
  for (Index n = 0; n < made.mesh.nodes(); ++n)
    made.displacements.row(n) = bending(made.mesh.points.row(n).transpose(), largestMm).transpose();
  return made;
}

Points placesAroundBlock(int count, double beyondMm, unsigned seed) {
  Draws draws(seed);
  Points places(count, 3);
  const Vector3d size(120, 80, 50);
  for (Index i = 0; i < count; ++i)
    for (int a = 0; a < 3; ++a) places(i, a) = -beyondMm + (size[a] + 2 * beyondMm) * draws.uniform();
  return places;
}

}  // namespace falciform::test
