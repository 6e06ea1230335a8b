#include "Testing/Support/BlockMesh.h"

#include <algorithm>
#include <array>
#include <random>

namespace falciform::test {

TetrahedralMesh blockMesh(const Vector3d& sizeMm, const Vector3i& cells) {
  const auto corner = [&](int x, int y, int z) { return (z * (cells[1] + 1) + y) * (cells[0] + 1) + x; };
  TetrahedralMesh mesh;
  mesh.points.resize(corner(cells[0], cells[1], cells[2]) + 1, 3);
  for (int z = 0; z <= cells[2]; ++z)
    for (int y = 0; y <= cells[1]; ++y)
      for (int x = 0; x <= cells[0]; ++x)
        mesh.points.row(corner(x, y, z)) =
            Vector3d(x, y, z).cwiseQuotient(cells.cast<double>()).cwiseProduct(sizeMm).transpose();
  mesh.elements.resize(6 * cells.prod(), 4);
  Index e = 0;
  std::array<int, 3> axes{0, 1, 2};
  for (int z = 0; z < cells[2]; ++z)
    for (int y = 0; y < cells[1]; ++y)
      for (int x = 0; x < cells[0]; ++x) {
        std::sort(axes.begin(), axes.end());
        do {  // each order of the axes is a walk from the low corner to the high one: one tetrahedron
          Vector3i at(x, y, z);
          mesh.elements(e, 0) = corner(x, y, z);
          for (int k = 0; k < 3; ++k) {
            ++at[axes[static_cast<std::size_t>(k)]];
            mesh.elements(e, k + 1) = corner(at[0], at[1], at[2]);
          }
          if (cornerVolume(mesh, e) < 0) std::swap(mesh.elements(e, 2), mesh.elements(e, 3));
          ++e;
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  return mesh;
}

TetrahedralMesh shakenBlockMesh(const Vector3d& sizeMm, const Vector3i& cells, double share, unsigned seed) {
  TetrahedralMesh mesh = blockMesh(sizeMm, cells);
  const Vector3d step = sizeMm.cwiseQuotient(cells.cast<double>());
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-share, share);
  for (Index n = 0; n < mesh.nodes(); ++n) {
    const Vector3d at = mesh.points.row(n).transpose();
    const bool inside = (at.array() > 1e-9).all() && (at.array() < sizeMm.array() - 1e-9).all();
    for (int k = 0; k < 3; ++k)
      if (inside) mesh.points(n, k) += uniform(random) * step[k];
  }
  return mesh;
}

}  // namespace falciform::test
