#include "Logic/Biomechanics/BoundaryFaces.h"

#include <algorithm>
#include <array>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

struct Face {
  std::array<int, 3> key;  ///< corners in ascending order
  int element, side;
  bool even;  ///< that order is a cyclic one of the face's own
};

std::vector<Face> sortedFaces(const TetrahedralMesh& mesh) {
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(4 * mesh.size()));
  for (Index e = 0; e < mesh.size(); ++e)
    for (int side = 0; side < 4; ++side) {
      Face face{.key = {}, .element = static_cast<int>(e), .side = side, .even = true};
      for (std::size_t k = 0; k < 3; ++k)
        face.key[k] = mesh.elements(e, kTetrahedronFaces[static_cast<std::size_t>(side)][k]);
      face.even =
          (face.key[0] < face.key[1]) + (face.key[1] < face.key[2]) + (face.key[2] < face.key[0]) == 2;
      std::sort(face.key.begin(), face.key.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.key != b.key ? a.key < b.key : a.element < b.element;
  });
  return faces;
}

std::vector<Face> singleFaces(const TetrahedralMesh& mesh) {
  const std::vector<Face> faces = sortedFaces(mesh);
  std::vector<Face> single;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].key == faces[i].key) ++end;
    if (end - i > 2)
      throw InputError("tetrahedra " + std::to_string(faces[i].element) + ", " +
                       std::to_string(faces[i + 1].element) + " and " + std::to_string(faces[i + 2].element) +
                       " share one face: some are doubled; mesh the surface anew");
    if (end - i == 2 && faces[i].even == faces[i + 1].even)
      throw InputError(
          "tetrahedra " + std::to_string(faces[i].element) + " and " + std::to_string(faces[i + 1].element) +
          " lie on the same side of one face: one is doubled or inverted; mesh the surface anew");
    if (end - i == 1) single.push_back(faces[i]);
    i = end;
  }
  std::sort(single.begin(), single.end(), [](const Face& a, const Face& b) {
    return a.element != b.element ? a.element < b.element : a.side < b.side;
  });
  return single;
}

}  // namespace

BoundaryFaces boundaryFaces(const TetrahedralMesh& mesh) {
  const std::vector<Face> single = singleFaces(mesh);
  const auto count = static_cast<Index>(single.size());
  BoundaryFaces faces;
  faces.quadratic = mesh.quadratic();
  faces.nodes = Eigen::Matrix<int, Eigen::Dynamic, 6, Eigen::RowMajor>::Constant(count, 6, -1);
  faces.areaVectors.resize(count, 3);
  for (Index f = 0; f < count; ++f) {
    const Face& face = single[static_cast<std::size_t>(f)];
    for (int k = 0; k < faces.nodesPerFace(); ++k)
      faces.nodes(f, k) =
          mesh.elements(face.element, kTetrahedronFaces[static_cast<std::size_t>(face.side)][k]);
    const auto corner = [&](int k) { return Vector3d(mesh.points.row(faces.nodes(f, k)).transpose()); };
    faces.areaVectors.row(f) = (corner(1) - corner(0)).cross(corner(2) - corner(0)).transpose() / 2;
    faces.elements.push_back(face.element);
  }
  return faces;
}

Points faceCentres(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  Points centres(faces.size(), 3);
  for (Index f = 0; f < faces.size(); ++f)
    centres.row(f) = (mesh.points.row(faces.nodes(f, 0)) + mesh.points.row(faces.nodes(f, 1)) +
                      mesh.points.row(faces.nodes(f, 2))) /
                     3;
  return centres;
}

double faceShare(bool quadratic, int k) { return quadratic == (k >= 3) ? 1.0 / 3 : 0.0; }

BoundarySurface boundarySurface(const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  std::vector<int> place(static_cast<std::size_t>(mesh.nodes()), -1);
  for (Index f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) place[static_cast<std::size_t>(faces.nodes(f, k))] = 0;
  BoundarySurface result;
  for (std::size_t n = 0; n < place.size(); ++n)
    if (place[n] == 0) {
      place[n] = static_cast<int>(result.nodes.size());
      result.nodes.push_back(static_cast<int>(n));
    }
  result.surface.frame = mesh.frame;
  result.surface.points = mesh.points(result.nodes, Eigen::all);
  result.surface.triangles.resize(faces.size(), 3);
  for (Index f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k)
      result.surface.triangles(f, k) = place[static_cast<std::size_t>(faces.nodes(f, k))];
  return result;
}

}  // namespace falciform
