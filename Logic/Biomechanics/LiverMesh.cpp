#include "Logic/Biomechanics/LiverMesh.h"

#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Remesh.h"
#include "Logic/Geometry/Tetrahedra.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

/// Of a regular tetrahedron with this edge, mm3.
double regularVolume(double edgeMm) { return edgeMm * edgeMm * edgeMm / (6 * std::sqrt(2.0)); }

}  // namespace

LiverMesh meshLiver(const Surface& preop, const std::vector<Surface>& tumours, const MeshSettings& settings,
                    const Progress& progress) {
  checkSettings(settings);
  checkSurface(preop, "the liver's surface");
  const Surface surface = remeshIsotropic(preop, settings.edgeLengthMm, 6, progress.part(0, 0.5));
  const double bound =
      settings.maxVolumeMm3 > 0 ? settings.maxVolumeMm3 : regularVolume(settings.edgeLengthMm);
  progress.report(0.5, "Filling with tetrahedra");
  LiverMesh result;
  result.mesh = tetrahedralise(surface, bound);
  result.mesh.frame = preop.frame;
  result.mesh.regions.assign(static_cast<std::size_t>(result.mesh.size()), 0);
  for (std::size_t k = 0; k < tumours.size(); ++k) {
    const TriangleTree tree(tumours[k]);
    for (Index e = 0; e < result.mesh.size(); ++e) {
      Vector3d centre = Vector3d::Zero();
      for (int c = 0; c < 4; ++c)
        centre += result.mesh.points.row(result.mesh.elements(e, c)).transpose() / 4;
      if (tree.closest(centre).side < 0)
        result.mesh.regions[static_cast<std::size_t>(e)] = static_cast<int>(k) + 1;
    }
  }
  if (settings.order == ElementOrder::Quadratic) result.mesh = quadraticMesh(result.mesh);
  result.report.nodes = result.mesh.nodes();
  result.report.elements = result.mesh.size();
  result.report.degreesOfFreedom = 3 * result.mesh.nodes();
  result.report.edgeLengthMm = settings.edgeLengthMm;
  progress.report(1, "Meshed");
  return result;
}

}  // namespace falciform
