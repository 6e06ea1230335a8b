#include "Logic/Core/Surface.h"

#include <algorithm>

#include "Logic/Core/Errors.h"

namespace falciform {

std::string patchName(const Surface& surface, int label) {
  if (const auto named = surface.patchNames.find(label); named != surface.patchNames.end())
    return named->second;
  if (label == patch::kNone) return "none";
  if (label == patch::kFalciform) return "falciform";
  if (label == patch::kInferiorRidge) return "inferior ridge";
  return "patch " + std::to_string(label);
}

std::vector<int> pointsOfPatch(const Surface& surface, int label) {
  std::vector<int> ids;
  for (Index i = 0; i < surface.size(); ++i)
    if (surface.patchAt(i) == label) ids.push_back(static_cast<int>(i));
  return ids;
}

std::vector<int> patchLabels(const Surface& surface) {
  std::vector<int> labels;
  int last = patch::kNone;  // neighbours in the list mostly bear one label
  for (const int label : surface.patch) {
    if (label == last || label == patch::kNone) continue;
    last = label;
    const auto place = std::lower_bound(labels.begin(), labels.end(), label);
    if (place == labels.end() || *place != label) labels.insert(place, label);
  }
  return labels;
}

Points transformed(const Points& points, const Isometry3d& targetFromSource) {
  return (points * targetFromSource.linear().transpose()).rowwise() +
         targetFromSource.translation().transpose();
}

Surface transformed(const Surface& surface, const Isometry3d& targetFromSource, const std::string& frame) {
  Surface moved = surface;
  moved.points = transformed(surface.points, targetFromSource);
  if (surface.normals.rows() > 0) moved.normals = surface.normals * targetFromSource.linear().transpose();
  moved.frame = frame;
  return moved;
}

void checkSurface(const Surface& surface, const std::string& what) {
  const Index n = surface.size();
  if (!surface.points.allFinite())
    throw InputError(what + ": some coordinates are not finite numbers; export the surface again");
  if (surface.triangles.size() > 0 && (surface.triangles.minCoeff() < 0 || surface.triangles.maxCoeff() >= n))
    throw InputError(what + ": a triangle names a point outside 0.." + std::to_string(n - 1) +
                     "; the file is damaged");
  const auto expect = [&](Index rows, const std::string& name) {
    if (rows != 0 && rows != n)
      throw InputError(what + ": array '" + name + "' has " + std::to_string(rows) + " values for " +
                       std::to_string(n) + " points; write it again with one value a point");
  };
  expect(static_cast<Index>(surface.patch.size()), "Patch");
  expect(surface.normals.rows(), "Normals");
  expect(surface.colours.rows(), "RGB");
  expect(surface.textureAt.rows(), "TCoords");
  for (const auto& [name, values] : surface.arrays) expect(values.size(), name);
  for (const int label : surface.patch)
    if (label < 0 || label > patch::kMax)
      throw InputError(what + ": patch label " + std::to_string(label) +
                       " lies outside 0..255; relabel the patch");
}

}  // namespace falciform
