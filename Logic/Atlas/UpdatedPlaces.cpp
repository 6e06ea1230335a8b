#include "Logic/Atlas/UpdatedPlaces.h"

namespace falciform {

Points scanFromPreop(const TetrahedralMesh& mesh, const UpdateResult& update, const Points& preopMm) {
  const MeshPlaces places(mesh, preopMm);
  return transformed(preopMm + Points(places.interpolate(update.displacements)), update.scanFromPreop);
}

}  // namespace falciform
