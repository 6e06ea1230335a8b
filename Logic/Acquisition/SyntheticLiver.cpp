#include "Logic/Acquisition/SyntheticLiver.h"

#include <algorithm>
#include <tuple>

#include "Logic/Acquisition/LiverPainting.h"
#include "Logic/Acquisition/LiverStructures.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {
namespace {

Box boxOf(const Ellipsoid& e) {
  Box box;
  box.row(0) = (e.centre - e.radii).array().transpose() - 5;
  box.row(1) = (e.centre + e.radii).array().transpose() + 5;
  return box;
}

std::uint16_t labelInside(const LiverStructures& structures, const Vector3d& p) {
  for (const Ellipsoid& tumour : structures.tumours)
    if (tumour.distance(p) < 0) return synthetic::kTumour;
  if (structures.portalVein.distance(p) < 0) return synthetic::kPortalVein;
  if (structures.hepaticVein.distance(p) < 0) return synthetic::kHepaticVein;
  return synthetic::kLiver;
}

}  // namespace

SyntheticLiver makeSyntheticLiver(const SyntheticLiverSettings& settings, const Progress& progress) {
  checkSettings(settings);
  const LiverShape shape(settings);
  const LiverStructures inside = placeStructures(shape);

  SyntheticLiver liver;
  progress.report(0, "Shaping the liver");
  const double edge = settings.edgeLengthMm;
  // The grid must catch the inferior margin, however coarse the mesh.
  liver.surface = meshImplicit([&](const Vector3d& p) { return shape.distance(p); }, shape.bounds(),
                               std::clamp(1.3 * edge, 1.3, 4.0), edge, progress.part(0, 0.8));
  liver.surface.patch = paintPatches(shape, liver.surface.points);
  liver.surface.normals = vertexNormals(liver.surface);
  liver.anatomical = anatomicalLandmarks(shape, liver.surface.points);

  const double fine = std::clamp(edge, 1.2, 2.0);  // vessels of 2 mm radius keep their shape
  for (std::size_t n = 0; n < inside.tumours.size(); ++n) {
    const Ellipsoid& tumour = inside.tumours[n];
    liver.structures["tumour " + std::to_string(n + 1)] =
        meshImplicit([&](const Vector3d& p) { return tumour.distance(p); }, boxOf(tumour), fine, fine,
                     progress.part(0.8, 0.84));
  }
  for (const auto& [name, tree, from] :
       {std::tuple("portal vein", &inside.portalVein, 0.84), {"hepatic vein", &inside.hepaticVein, 0.92}})
    liver.structures[name] = meshImplicit([&body = *tree](const Vector3d& p) { return body.distance(p); },
                                          tree->box(), fine, fine, progress.part(from, from + 0.08));
  liver.targets = insideTargets(shape, inside);
  progress.report(1);
  return liver;
}

LabelMap makeSyntheticLabelMap(const SyntheticLiverSettings& settings, const Progress& progress) {
  checkSettings(settings);
  const LiverShape shape(settings);
  const LiverStructures inside = placeStructures(shape);
  const Image depth = sampleDepth([&](const Vector3d& p) { return shape.distance(p); }, shape.bounds(),
                                  settings.voxelMm, progress.part(0, 0.5));
  LabelMap labels;
  labels.size = depth.size;
  labels.worldFromIndex = depth.worldFromIndex;
  labels.voxels.resize(depth.voxels.size());
  const auto perSlice = static_cast<std::size_t>(depth.size.x()) * static_cast<std::size_t>(depth.size.y());
  for (int k = 0; k < depth.size.z(); ++k) {
    progress.report(0.5 + 0.5 * k / depth.size.z(), "Labelling voxels");
    forEachChunk(perSlice, 2048, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const std::size_t at = static_cast<std::size_t>(k) * perSlice + n;
        if (depth.voxels[at] <= 0) continue;
        const std::size_t j = n / static_cast<std::size_t>(depth.size.x());
        const std::size_t i = n - j * static_cast<std::size_t>(depth.size.x());
        const Vector3d index(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        labels.voxels[at] = labelInside(inside, depth.world(index));
      }
    });
  }
  progress.report(1);
  return labels;
}

}  // namespace falciform
