#include "Testing/CommandLine/SmallCase.h"

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

SmallCase smallCase() {
  SmallCase made;
  made.preop = lumpyBody(4);
  made.scanFromPreop = randomMotion(11, 80);
  const Vector3d centre = centroid(made.preop.points);
  // The side that carries most of the patches: the scanner sees half of the body.
  Vector3d towards = Vector3d::Zero();
  std::vector<int> seen;
  for (Index i = 0; i < made.preop.size(); ++i)
    if (made.preop.patchAt(i) > 0) towards += (made.preop.points.row(i).transpose() - centre).normalized();
  for (Index i = 0; i < made.preop.size(); ++i)
    if ((made.preop.points.row(i).transpose() - centre).dot(towards) > 0) seen.push_back(static_cast<int>(i));
  made.scan = transformed(subset(made.preop, seen), made.scanFromPreop, "scanner");
  return made;
}

SmallCase writeSmallCase(const std::filesystem::path& folder) {
  SmallCase made = smallCase();
  writeSurface(folder / "preop.vtp", made.preop, Overwrite::Refuse);
  writeSurface(folder / "scan.vtp", made.scan, Overwrite::Refuse);
  return made;
}

LabelMap ballMap(double scale) {
  LabelMap map;
  map.size = {40, 40, 40};
  map.voxels.assign(40 * 40 * 40, 0);
  map.worldFromIndex.topLeftCorner<3, 3>() *= 4 * scale;
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        if ((Vector3d(i, j, k) - Vector3d::Constant(19.5)).norm() * 4 < 60) map.at(i, j, k) = 3;
  return map;
}

}  // namespace falciform::test
