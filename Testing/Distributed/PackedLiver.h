#pragma once
#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Biomechanics/Supports.h"

namespace falciform::test {

/// The built-in liver of quadratic tetrahedra and the thesis's tissue on its back, packed by 1 mm below.
struct PackedLiver {
  TetrahedralMesh mesh;
  std::vector<Material> materials{{.youngsModulusMPa = 0.015, .poissonsRatio = 0.47}};
  std::vector<NodeConstraint> constraints;

  explicit PackedLiver(double edgeLengthMm) {
    const Surface surface = makeSyntheticLiver({.edgeLengthMm = 6, .voxelMm = 6}).surface;
    mesh = meshLiver(surface, {}, {.edgeLengthMm = edgeLengthMm}).mesh;
    const BoundaryFaces faces = boundaryFaces(mesh);
    const SupportSites sites = findSupportSites(surface, mesh, faces);
    const std::vector<Support> supports{
        {.name = "cava", .kind = SupportKind::Fixed, .faces = sites.venaCava},
        {.name = "bed", .kind = SupportKind::Sliding, .faces = sites.posteriorBed},
        {.name = "pack",
         .kind = SupportKind::Pushed,
         .faces = packingSite(sites, packingSites(sites, 1).front(), 40),
         .pushMm = 1}};
    constraints = nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), supports);
  }
};

}  // namespace falciform::test
