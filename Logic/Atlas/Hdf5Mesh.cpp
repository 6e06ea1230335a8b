#include "Logic/Atlas/Hdf5Mesh.h"

namespace falciform {

namespace {

std::uint64_t count(Index n) { return static_cast<std::uint64_t>(n); }

}  // namespace

void writeMeshArrays(Hdf5Writer& file, const TetrahedralMesh& mesh) {
  file.text("mesh/frame", mesh.frame);
  file.numbers("mesh/points_mm", mesh.points.data(), {count(mesh.nodes()), 3});
  file.integers("mesh/elements", {mesh.elements.data(), mesh.elements.data() + mesh.elements.size()},
                {count(mesh.size()), count(mesh.elements.cols())});
  std::vector<std::int32_t> regions;
  for (Index e = 0; e < mesh.size(); ++e) regions.push_back(mesh.regionOf(e));
  file.integers("mesh/regions", regions, {regions.size()});
}

TetrahedralMesh readMeshArrays(const Hdf5Reader& file, const std::string& what) {
  Lengths points{Hdf5Reader::kAny, 3}, elements{Hdf5Reader::kAny, Hdf5Reader::kAny};
  const std::vector<double> coordinates = file.numbers("mesh/points_mm", points);
  const std::vector<std::int32_t> corners = file.integers("mesh/elements", elements);
  Lengths regions{elements[0]};
  TetrahedralMesh mesh;
  mesh.points = Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(points[0]), 3);
  mesh.elements = Eigen::Map<const TetrahedralMesh::Elements>(corners.data(), static_cast<Index>(elements[0]),
                                                              static_cast<Index>(elements[1]));
  mesh.regions = file.integers("mesh/regions", regions);
  mesh.frame = file.text("mesh/frame");
  checkMesh(mesh, "the mesh in '" + what + "'");
  return mesh;
}

}  // namespace falciform
