#include "Logic/Deformation/Normalisation/LiverRegistration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Deformation/Normalisation/DistanceSamples.h"
#include "Logic/Deformation/Normalisation/LevelFit.h"
#include "Logic/Deformation/Normalisation/LiverAlignment.h"
#include "Logic/Geometry/GridField.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

/// Distance fields on cells of this size, out to this far, for levels whose centres are not nearer than
/// `fromSpacingMm`: the three resolutions of the thesis.
struct Resolution {
  double cellMm, bandMm, fromSpacingMm;
};
constexpr std::array<Resolution, 3> kResolutions{{{6, 60, 40}, {3, 20, 15}, {1.5, 8, 0}}};
/// Samples to a spacing along each axis: a function is seen at some hundred places.
constexpr double kSamplesPerSpacing = 3;

void checkClosed(const Surface& surface, const std::string& what) {
  const TopologyReport topology = inspectTopology(surface);
  const bool closed = topology.closedManifold();
  if (closed && signedVolume(surface) > 0) return;
  throw InputError(
      "the " + what + " liver " +
      (closed ? "has triangles that face inwards; turn them"
              : "is no closed surface (" + describeTopology(topology) + "); import it from its label map"));
}

/// The lattice of functions over a surface's box, evenly about its middle.
BasisWarp latticeOver(const Surface& surface, double spacingMm) {
  const auto box = boundingBox(surface.points);
  const Vector3d low = box.row(0).transpose(), size = (box.row(1) - box.row(0)).transpose();
  const Vector3i counts = (size / spacingMm).array().ceil().cast<int>() + 1;
  const Vector3d covered = (counts.array() - 1).cast<double>() * spacingMm;
  return {low - (covered - size) / 2, spacingMm, counts};
}

double spacingOf(int level, double coarsestMm, const NormalisationSettings& settings) {
  const double share = settings.levels > 1 ? static_cast<double>(level) / (settings.levels - 1) : 1;
  return coarsestMm * std::pow(settings.finestMm / coarsestMm, share);
}

LevelPlan planOf(double spacingMm, const Resolution& resolution, const NormalisationSettings& settings) {
  LevelPlan plan;
  // Coarse levels look far, so that a lobe is drawn out of where it only seems to fit; fine ones stay near.
  const double reach = spacingMm > kResolutions[1].fromSpacingMm ? spacingMm : spacingMm / 2;
  plan.bandMm = std::clamp(reach, 2 * resolution.cellMm, resolution.bandMm);
  plan.compressionLimit = settings.compressionLimit;
  return plan;
}

}  // namespace

LiverMap registerLivers(const Surface& target, const Surface& source, const NormalisationSettings& settings,
                        const Progress& progress) {
  checkClosed(target, "target");
  checkClosed(source, "source");
  const auto box = boundingBox(source.points);
  const double coarsest = std::max((box.row(1) - box.row(0)).maxCoeff() / 2, settings.finestMm);
  LiverMap map;
  map.sourceFromTarget = Eigen::Translation3d(centroid(source.points) - centroid(target.points));
  int level = 0;
  for (const Resolution& resolution : kResolutions) {
    if (level > 0 && level == settings.levels) break;
    progress.report(static_cast<double>(level) / settings.levels, "Distances");
    const GridField sourceField = signedDistanceField(source, resolution.cellMm, resolution.bandMm),
                    targetField = signedDistanceField(target, resolution.cellMm, resolution.bandMm);
    if (level == 0)
      map.sourceFromTarget =
          alignLivers(sourceField, samplesOf(targetField, resolution.bandMm, resolution.cellMm),
                      resolution.bandMm, map.sourceFromTarget);
    for (; level < settings.levels; ++level) {
      const double spacing = spacingOf(level, coarsest, settings);
      if (spacing < resolution.fromSpacingMm) break;
      progress.report(static_cast<double>(level) / settings.levels, "Adaptive bases");
      const LevelPlan plan = planOf(spacing, resolution, settings);
      DistanceSamples samples =
          samplesOf(targetField, plan.bandMm, std::clamp(spacing / kSamplesPerSpacing, 1.0, 8.0));
      samples.places = map.toSource(samples.places);
      map.warps.push_back(fitLevel(sourceField, samples, latticeOver(source, spacing), plan));
    }
  }
  return map;
}

}  // namespace falciform
