#pragma once
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Core/TetrahedralMesh.h"

namespace falciform {

/// The outer surface of a tetrahedral mesh: the faces that belong to one element only.
struct BoundaryFaces {
  Eigen::Matrix<int, Eigen::Dynamic, 6, Eigen::RowMajor>
      nodes;           ///< F x 6: three corners counter-clockwise from outside, then the nodes on ab, bc,
                       ///< ca; those are -1 in a linear mesh
  Points areaVectors;  ///< F x 3, mm2: outward normal times area
  std::vector<int> elements;  ///< F: whose face it is
  bool quadratic = false;

  [[nodiscard]] Index size() const { return nodes.rows(); }
  [[nodiscard]] int nodesPerFace() const { return quadratic ? 6 : 3; }
};

/// In order of element and face. Throws InputError where three elements or more share a face, or two that
/// share one lie on the same side of it.
[[nodiscard]] BoundaryFaces boundaryFaces(const TetrahedralMesh& mesh);

/// F x 3, mm: the middle of each face's corners.
[[nodiscard]] Points faceCentres(const TetrahedralMesh& mesh, const BoundaryFaces& faces);

/// The weight of a face's area that its node `k` of 0..5 carries, the integral of N_k over the face by its
/// area: a third for a linear mesh's corners, 0 for a quadratic one's corners and a third for its edge nodes.
[[nodiscard]] double faceShare(bool quadratic, int k);

/// The boundary as a triangle surface over all mesh nodes' corners that lie on it, in order of node, and
/// those nodes' numbers: what a viewer draws and a brush paints.
struct BoundarySurface {
  Surface surface;
  std::vector<int> nodes;  ///< of each surface point
};
[[nodiscard]] BoundarySurface boundarySurface(const TetrahedralMesh& mesh, const BoundaryFaces& faces);

}  // namespace falciform
