#include "Widgets/Views/DataProbe.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "Widgets/Rendering/SurfaceGeometry.h"

namespace falciform {
namespace {

std::string describe(const ShownSurface& shown, const SurfaceHit& hit) {
  const Surface& surface = *shown.surface;
  char text[160];
  std::snprintf(text, sizeof text, " · vertex %d · (%.1f, %.1f, %.1f) mm %s", hit.vertex, hit.point.x(),
                hit.point.y(), hit.point.z(), surface.frame.c_str());
  std::string line = shown.title + text;
  if (const int label = surface.patchAt(hit.vertex); label != patch::kNone)
    line += " · " + patchName(surface, label);
  if (const auto found = surface.arrays.find(kSignedDistance); found != surface.arrays.end()) {
    const double value = found->second[hit.vertex];
    if (std::isfinite(value))
      std::snprintf(text, sizeof text, " · distance %+.2f mm", value);
    else
      std::snprintf(text, sizeof text, " · no distance here");
    line += text;
  }
  return line;
}

}  // namespace

const SurfacePicker& DataProbe::pickerFor(const ShownSurface& shown) {
  auto& picker = pickers_[shown.part];
  if (!picker || (picker->surface() != shown.surface && !sameGeometry(*picker->surface(), *shown.surface)))
    picker = std::make_unique<SurfacePicker>(shown.surface);
  return *picker;
}

std::string DataProbe::at(CaseScene& scene, double x, double y) {
  const PickRay sceneRay = pickRay(scene.scene().renderer(), x, y);
  double nearest = std::numeric_limits<double>::infinity();
  std::string words;
  for (const ShownSurface& shown : scene.shown()) {
    const Isometry3d surfaceFromScene = shown.sceneFromSurface.inverse();
    const PickRay ray{surfaceFromScene * sceneRay.origin, surfaceFromScene.linear() * sceneRay.direction};
    const auto hit = pickerFor(shown).pick(ray);
    if (!hit) continue;
    const double depth = (hit->point - ray.origin).dot(ray.direction);
    if (depth >= nearest) continue;
    nearest = depth;
    words = describe(shown, *hit);
  }
  return words;
}

}  // namespace falciform
