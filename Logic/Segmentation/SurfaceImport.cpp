#include "Logic/Segmentation/SurfaceImport.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Remesh.h"
#include "Logic/Segmentation/Mask.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {

namespace {

constexpr double kShortestOrganMm = 10, kLongestOrganMm = 1000;
constexpr double kSmallestLiverMl = 200, kLargestLiverMl = 4000;
constexpr double kVolumeAim = 1e-3, kVolumeBound = 1e-2;  ///< relative: restored to, and promised

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream stream;
  stream.precision(4);
  (stream << ... << parts);
  return stream.str();
}

void checkGrid(const LabelMap& map) {
  if (map.size.minCoeff() < 1 || static_cast<Index>(map.voxels.size()) != map.size.cast<Index>().prod())
    throw InputError(text("the label map of ", map.size.x(), " x ", map.size.y(), " x ", map.size.z(),
                          " voxels holds ", map.voxels.size(), " values; read it again from its file"));
  const Vector3d spacing = map.spacing();
  if (!map.worldFromIndex.allFinite() || !(spacing.minCoeff() > 0) ||
      !(map.voxelVolume() > 1e-3 * spacing.prod()))
    throw InputError(text("the label map's axes are degenerate (spacing ", spacing.x(), " x ", spacing.y(),
                          " x ", spacing.z(), " mm); mend the geometry in its header"));
}

/// "1 (2034 voxels), 5 (77 voxels)", the first twenty.
std::string listed(const std::vector<std::pair<int, std::size_t>>& counts) {
  std::string all;
  for (std::size_t i = 0; i < std::min<std::size_t>(counts.size(), 20); ++i)
    all += text(all.empty() ? "" : ", ", counts[i].first, " (", counts[i].second, " voxels)");
  return all + (counts.size() > 20 ? text(" and ", counts.size() - 20, " more") : "");
}

/// Flags of the selected values; throws for a value that the map does not hold.
std::vector<char> selected(const LabelMap& map, const std::vector<int>& labels) {
  const auto counts = labelCounts(map);
  if (counts.empty())
    throw InputError("the label map is empty: every voxel is background; choose another file");
  std::vector<char> isOrgan(65536, 0);
  if (labels.empty()) std::fill(isOrgan.begin() + 1, isOrgan.end(), char{1});
  for (const int label : labels) {
    const bool there =
        std::any_of(counts.begin(), counts.end(), [&](const auto& c) { return c.first == label; });
    if (!there) throw InputError(text("label ", label, " is not in the map; choose from ", listed(counts)));
    isOrgan[static_cast<std::size_t>(label)] = 1;
  }
  return isOrgan;
}

/// Faces of the whole map that the selection reaches.
bool touchesBorder(const LabelMap& map, const Mask& mask) {
  const Matrix4d mapFromMask = map.worldFromIndex.inverse() * mask.worldFromIndex;
  const Vector3i last = map.size - Vector3i::Ones();
  for (int k = kMaskMargin; k < mask.size.z() - kMaskMargin; ++k)
    for (int j = kMaskMargin; j < mask.size.y() - kMaskMargin; ++j)
      for (int i = kMaskMargin; i < mask.size.x() - kMaskMargin; ++i) {
        if (!mask.at(i, j, k)) continue;
        const Vector3i there =
            (mapFromMask * Eigen::Vector4d(i, j, k, 1)).head<3>().array().round().matrix().cast<int>();
        if (there.minCoeff() <= 0 || (last - there).minCoeff() <= 0) return true;
      }
  return false;
}

/// "94 voxels (0.083 ml)".
std::string voxels(std::size_t count, const LabelMap& map) {
  return text(count, count == 1 ? " voxel (" : " voxels (",
              static_cast<double>(count) * map.voxelVolume() / 1000, " ml)");
}

Mask organMask(const LabelMap& map, const SurfaceImportSettings& settings, SurfaceImportResult& result) {
  Mask mask = cutOut(map, selected(map, settings.labels));
  if (settings.largestComponent) {
    const ComponentCounts counts = keepLargestComponent(mask);
    result.droppedVoxels = counts.droppedVoxels;
    if (counts.pieces > 1)
      result.warnings.push_back(text(counts.pieces - 1,
                                     counts.pieces == 2 ? " smaller piece" : " smaller pieces", " of ",
                                     voxels(counts.droppedVoxels, map), " dropped"));
  }
  if (settings.fillCavities) {
    result.filledVoxels = fillCavities(mask);
    if (result.filledVoxels > 0)
      result.warnings.push_back(text("cavities of ", voxels(result.filledVoxels, map), " filled"));
  }
  result.selectedVoxels = countOrgan(mask);
  result.voxelVolumeMm3 = static_cast<double>(result.selectedVoxels) * map.voxelVolume();
  if (touchesBorder(map, mask))
    result.warnings.emplace_back("the organ touches the border of the volume: the surface is cut flat there");
  return mask;
}

void checkExtent(const Surface& surface) {
  const auto box = boundingBox(surface.points);
  const double extent = (box.row(1) - box.row(0)).maxCoeff();
  if (extent < kShortestOrganMm)
    throw InputError(text("the organ is ", extent,
                          " mm long; the spacing may be in metres, or the label a fragment: "
                          "give the spacing in mm or choose another label"));
  if (extent > kLongestOrganMm)
    throw InputError(
        text("the organ is ", extent, " mm long; the spacing may be in micrometres: give it in mm"));
}

Image asField(const Mask& mask) {
  Image field;
  field.size = mask.size;
  field.worldFromIndex = mask.worldFromIndex;
  field.voxels.assign(mask.voxels.begin(), mask.voxels.end());
  return field;
}

/// Marching cubes cuts corners and smoothing shrinks: both are undone by small equal steps along the normals.
/// Stops when steps no longer help, as on a sponge of single voxels; checkResult then warns.
void restoreVolume(Surface& surface, double volume) {
  for (int step = 0; step < 20; ++step) {
    const double missing = volume - signedVolume(surface);
    if (std::abs(missing) < kVolumeAim * volume) return;
    const double limit = meanEdgeLength(surface) / 10;
    const double offset = std::clamp(missing / area(surface), -limit, limit);
    const Points before = surface.points;
    surface.points += offset * vertexNormals(surface);
    if (std::abs(volume - signedVolume(surface)) < std::abs(missing)) continue;
    surface.points = before;
    return;
  }
}

bool volumeKept(const Surface& surface, double volume) {
  return std::abs(signedVolume(surface) - volume) <= kVolumeBound * volume;
}

/// A piece of few voxels melts under smoothing that suits an organ: fewer iterations then.
Surface smoothed(const Surface& steps, const SurfaceImportSettings& settings, SurfaceImportResult& result) {
  const double volume = result.voxelVolumeMm3;
  for (int iterations = settings.smoothingIterations;; iterations /= 2) {
    Surface smooth = smoothWindowedSinc(steps, iterations, settings.passBand);
    restoreVolume(smooth, volume);
    if (iterations > 0 && !volumeKept(smooth, volume)) continue;
    if (iterations < settings.smoothingIterations)
      result.warnings.push_back(text("smoothed with ", iterations, " iterations instead of ",
                                     settings.smoothingIterations, ", which would not keep the volume"));
    return smooth;
  }
}

void checkResult(SurfaceImportResult& result) {
  result.topology = inspectTopology(result.surface);
  if (!result.topology.closedManifold())
    throw InputError("the surface of the label map is not a closed manifold (" +
                     describeTopology(result.topology) +
                     "); smooth the segmentation, or choose another edge length");
  result.surfaceVolumeMm3 = signedVolume(result.surface);
  if (!volumeKept(result.surface, result.voxelVolumeMm3))
    result.warnings.push_back(text("the surface encloses ", result.surfaceVolumeMm3 / 1000,
                                   " ml, the voxels ", result.voxelVolumeMm3 / 1000,
                                   " ml: too few voxels for the smoothing or edge length"));
  const double ml = result.voxelVolumeMm3 / 1000;
  if (ml < kSmallestLiverMl || ml > kLargestLiverMl)
    result.warnings.push_back(text("the organ's volume is ", ml, " ml: is this a liver?"));
}

}  // namespace

SurfaceImportResult importSurface(const LabelMap& map, const SurfaceImportSettings& settings,
                                  const Progress& progress) {
  checkSettings(settings);
  checkGrid(map);
  SurfaceImportResult result;

  progress.report(0, "Selecting the organ");
  const Mask mask = organMask(map, settings, result);

  progress.report(0.2, "Marching cubes");
  Surface surface = isosurface(asField(mask), 0.5);
  checkExtent(surface);

  progress.report(0.35, "Smoothing");
  surface = smoothed(surface, settings, result);

  if (settings.edgeLengthMm > 0) {
    surface = remeshIsotropic(surface, settings.edgeLengthMm, 6, progress.part(0.6, 0.9));
    restoreVolume(surface, result.voxelVolumeMm3);
  }

  progress.report(0.9, "Checking the surface");
  result.surface = std::move(surface);
  checkResult(result);
  result.quality = measureQuality(result.surface, mask);
  if (const Index pairs = result.quality.crossings; pairs > 0)
    result.warnings.push_back(text("the surface cuts through itself at ", pairs,
                                   pairs == 1 ? " pair" : " pairs",
                                   " of triangles: smooth less, or choose "
                                   "another edge length"));
  progress.report(1, "Surface ready");
  return result;
}

}  // namespace falciform
