#include "Logic/Biomechanics/QuadraticMesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"

namespace falciform {

namespace {

std::uint64_t edgeKey(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

}  // namespace

TetrahedralMesh quadraticMesh(const TetrahedralMesh& linear) {
  checkMesh(linear, "the mesh");
  if (linear.quadratic()) return linear;
  TetrahedralMesh mesh{.points = {}, .elements = {}, .regions = linear.regions, .frame = linear.frame};
  mesh.elements.resize(linear.size(), 10);
  std::unordered_map<std::uint64_t, int> middleOf;
  middleOf.reserve(static_cast<std::size_t>(linear.size()) * 3 / 2);
  std::vector<std::array<int, 2>> ends;
  for (Index e = 0; e < linear.size(); ++e) {
    mesh.elements.row(e).head(4) = linear.elements.row(e);
    for (int k = 0; k < 6; ++k) {
      const auto [from, to] = kTetrahedronEdges[static_cast<std::size_t>(k)];
      const int a = linear.elements(e, from), b = linear.elements(e, to);
      const auto [found, isNew] =
          middleOf.try_emplace(edgeKey(a, b), static_cast<int>(linear.nodes() + std::ssize(ends)));
      if (isNew) ends.push_back({a, b});
      mesh.elements(e, 4 + k) = found->second;
    }
  }
  mesh.points.resize(linear.nodes() + std::ssize(ends), 3);
  mesh.points.topRows(linear.nodes()) = linear.points;
  for (std::size_t i = 0; i < ends.size(); ++i)
    mesh.points.row(linear.nodes() + static_cast<Index>(i)) =
        (linear.points.row(ends[i][0]) + linear.points.row(ends[i][1])) / 2;
  return mesh;
}

TetrahedralMesh linearMesh(const TetrahedralMesh& quadratic) {
  checkMesh(quadratic, "the mesh");
  if (!quadratic.quadratic()) return quadratic;
  std::vector<int> newId(static_cast<std::size_t>(quadratic.nodes()), -1);
  const auto corners = quadratic.elements.leftCols(4);
  for (Index e = 0; e < corners.rows(); ++e)
    for (Index k = 0; k < 4; ++k) newId[static_cast<std::size_t>(corners(e, k))] = 0;
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(newId.size()); ++i)
    if (newId[static_cast<std::size_t>(i)] == 0) {
      newId[static_cast<std::size_t>(i)] = static_cast<int>(kept.size());
      kept.push_back(i);
    }
  TetrahedralMesh mesh{.points = quadratic.points(kept, Eigen::all),
                       .elements = {},
                       .regions = quadratic.regions,
                       .frame = quadratic.frame};
  mesh.elements = corners.unaryExpr([&](int i) { return newId[static_cast<std::size_t>(i)]; });
  return mesh;
}

}  // namespace falciform
