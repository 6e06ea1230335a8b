#include "Widgets/Views/DataProbe.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>

#include "Logic/Core/Results.h"
#include "Logic/Deformation/RegionStatistics.h"
#include "Widgets/Rendering/SurfaceGeometry.h"

namespace falciform {
namespace {

/// "signed distance +2.31 mm", "signed distance: not covered"
std::string valueWords(const Surface& surface, int vertex, const ScalarMap& map) {
  const auto found = surface.arrays.find(map.array);
  const bool known = found != surface.arrays.end() && std::isfinite(found->second[vertex]);
  std::string words = map.title;
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  if (!known) return words + ": " + map.noValue;
  const double value = found->second[vertex];
  char text[64];
  // Hundredths of a mm, and as many digits of what is far below 1.
  const bool small = std::max(std::abs(map.low), std::abs(map.high)) < 1;
  std::snprintf(
      text, sizeof text,
      map.palette == Palette::Diverging ? (small ? " %+.3g" : " %+.2f") : (small ? " %.3g" : " %.2f"), value);
  return words + text + (map.unit.empty() ? "" : " " + map.unit);
}

std::string describe(const ShownSurface& shown, const SurfaceHit& hit) {
  const Surface& surface = *shown.surface;
  std::string line = shown.title;
  if (shown.map) line += " · " + valueWords(surface, hit.vertex, *shown.map);
  if (const int label = surface.patchAt(hit.vertex); label != patch::kNone)
    line += " · " + patchName(surface, label);
  if (const auto segments = surface.arrays.find(kCouinaudSegment); segments != surface.arrays.end())
    if (const double segment = segments->second[hit.vertex]; segment > 0)
      line += " · " + segmentName(static_cast<int>(segment));
  const Vector3d place = shown.lpsFromSurface ? *shown.lpsFromSurface * hit.point : hit.point;
  char text[160];
  std::snprintf(text, sizeof text, " · (%.1f, %.1f, %.1f) mm %s · vertex %d", place.x(), place.y(), place.z(),
                shown.lpsFromSurface ? "LPS" : surface.frame.c_str(), hit.vertex);
  return line + text;
}

}  // namespace

const SurfacePicker& DataProbe::pickerFor(const ShownSurface& shown) {
  auto& picker = pickers_[shown.part];
  if (!picker || (picker->surface() != shown.surface && !sameGeometry(*picker->surface(), *shown.surface)))
    picker = std::make_unique<SurfacePicker>(shown.surface);
  return *picker;
}

std::string DataProbe::at(vtkRenderer* renderer, const std::vector<ShownSurface>& shown, double x, double y) {
  const PickRay sceneRay = pickRay(renderer, x, y);
  double nearest = std::numeric_limits<double>::infinity();
  std::string words;
  for (const ShownSurface& one : shown) {
    const Isometry3d surfaceFromScene = one.sceneFromSurface.inverse();
    const PickRay ray{surfaceFromScene * sceneRay.origin, surfaceFromScene.linear() * sceneRay.direction};
    const auto hit = pickerFor(one).pick(ray);
    if (!hit) continue;
    const double depth = (hit->point - ray.origin).dot(ray.direction);
    if (depth >= nearest) continue;
    nearest = depth;
    words = describe(one, *hit);
  }
  return words;
}

}  // namespace falciform
