#include "Testing/Logic/Atlas/SlabLiver.h"

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Testing/Support/BlockMesh.h"

namespace falciform::test {

SlabLiver slabLiver(bool tumour) {
  SlabLiver slab;
  const Vector3d size(120, 60, 40);
  slab.mesh = quadraticMesh(shakenBlockMesh(size, {6, 3, 2}, 0.15, 11));
  slab.faces = boundaryFaces(slab.mesh);
  if (tumour) {
    slab.mesh.regions.assign(static_cast<std::size_t>(slab.mesh.size()), 0);
    for (Index e = 0; e < slab.mesh.size(); ++e)
      if (std::abs(slab.mesh.points(slab.mesh.elements(e, 0), 0) - 60) < 15)
        slab.mesh.regions[static_cast<std::size_t>(e)] = 1;
  }
  SupportSites& sites = slab.sites;
  sites.boundary = boundarySurface(slab.mesh, slab.faces);
  sites.areasMm2 = slab.faces.areaVectors.rowwise().norm();
  sites.centres.resize(slab.faces.size(), 3);
  for (Index f = 0; f < slab.faces.size(); ++f) {
    sites.centres.row(f).setZero();
    for (int k = 0; k < 3; ++k) sites.centres.row(f) += slab.mesh.points.row(slab.faces.nodes(f, k)) / 3;
    const Vector3d centre = sites.centres.row(f).transpose();
    const int face = static_cast<int>(f);
    if (centre[1] > size[1] - 1e-9)
      (centre[0] < 40 ? sites.venaCava : sites.posteriorBed).push_back(face);
    else if (centre[2] < 1e-9)
      (centre[0] > 60 ? sites.leftUnderside : sites.rightUnderside).push_back(face);
  }
  return slab;
}

double largest(const Points& field) { return field.rowwise().norm().maxCoeff(); }

}  // namespace falciform::test
