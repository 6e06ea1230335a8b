#include "Logic/Deformation/Normalisation/LiverRegistration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Deformation/Normalisation/FieldSample.h"
#include "Logic/Deformation/Normalisation/FieldSamples.h"
#include "Logic/Deformation/Normalisation/ImageField.h"
#include "Logic/Deformation/Normalisation/LevelFit.h"
#include "Logic/Deformation/Normalisation/LiverAlignment.h"
#include "Logic/Geometry/GridField.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"

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

/// How far from the surfaces a level compares distances.
double bandOf(double spacingMm, const Resolution& resolution) {
  // Coarse levels look far, so that a lobe is drawn out of where it only seems to fit; fine ones stay near.
  const double reach = spacingMm > kResolutions[1].fromSpacingMm ? spacingMm : spacingMm / 2;
  return std::clamp(reach, 2 * resolution.cellMm, resolution.bandMm);
}

/// What the levels of one resolution compare.
struct Fields {
  GridField sourceDistance, targetDistance;
  GridField sourceImage, targetImage;  ///< empty where there are none
};

/// A liver and what every resolution asks of it.
struct Liver {
  explicit Liver(const Surface& of) : surface(of), tree(of) {}
  [[nodiscard]] GridField distances(const Resolution& resolution) const {
    return signedDistanceField(surface, tree, resolution.cellMm, resolution.bandMm);
  }

  const Surface& surface;
  TriangleTree tree;
};

Fields fieldsOf(const Liver& target, const Liver& source, const CtPair* images,
                const Resolution& resolution) {
  Fields fields;
  fields.sourceDistance = source.distances(resolution);
  fields.targetDistance = target.distances(resolution);
  if (images == nullptr) return fields;
  fields.targetImage = imageField(images->target, target.surface, resolution.cellMm, resolution.bandMm);
  fields.sourceImage = imageField(images->source, source.surface, resolution.cellMm, resolution.bandMm);
  return fields;
}

constexpr double kLowestHu = -150, kHighestHu = 250, kAroundMm = 8;

/// Only what lies in the target's liver or near it.
FieldSamples imageSamples(const Fields& fields, double everyMm) {
  FieldSamples all = samplesOf(fields.targetDistance, 1e9, everyMm), kept;
  std::vector<Index> rows;
  for (std::size_t i = 0; i < all.values.size(); ++i)
    if (all.values[i] < kAroundMm) rows.push_back(static_cast<Index>(i));
  kept.places = all.places(rows, Eigen::all);
  for (Index i = 0; i < kept.places.rows(); ++i)
    kept.values.push_back(
        static_cast<float>(sampleField(fields.targetImage, kept.places.row(i).transpose()).value));
  return kept;
}

LiverMap registerBoth(const Surface& target, const Surface& source, const CtPair* images,
                      const NormalisationSettings& settings, const Progress& progress) {
  checkClosed(target, "target");
  checkClosed(source, "source");
  const Liver targetLiver(target), sourceLiver(source);
  const auto box = boundingBox(source.points);
  const double coarsest = std::max((box.row(1) - box.row(0)).maxCoeff() / 2, settings.finestMm);
  LevelPlan plan;
  plan.compressionLimit = settings.compressionLimit;
  if (images != nullptr) plan.leastGain = 0.001;  // information grows by small shares
  LiverMap map;
  map.sourceFromTarget = Eigen::Translation3d(centroid(source.points) - centroid(target.points));
  int level = 0;
  for (const Resolution& resolution : kResolutions) {
    if (level > 0 && level == settings.levels) break;
    progress.report(static_cast<double>(level) / settings.levels, "Distances");
    const Fields fields = fieldsOf(targetLiver, sourceLiver, images, resolution);
    if (level == 0)
      map.sourceFromTarget = alignLivers(
          fields.sourceDistance, samplesOf(fields.targetDistance, resolution.bandMm, resolution.cellMm),
          resolution.bandMm, map.sourceFromTarget);
    for (; level < settings.levels; ++level) {
      const double spacing = spacingOf(level, coarsest, settings);
      if (spacing < resolution.fromSpacingMm) break;
      progress.report(static_cast<double>(level) / settings.levels, "Adaptive bases");
      const double every = std::clamp(spacing / kSamplesPerSpacing, 1.0, 8.0),
                   band = bandOf(spacing, resolution);
      FieldSamples samples =
          images == nullptr ? samplesOf(fields.targetDistance, band, every) : imageSamples(fields, every);
      samples.places = map.toSource(samples.places);
      const auto fit = [&](const Similarity& similarity) {
        map.warps.push_back(fitLevel(similarity, samples.places, latticeOver(source, spacing), plan));
      };
      if (images == nullptr)
        fit(DistanceSimilarity(fields.sourceDistance, samples.values, band));
      else
        fit(MutualInformation(fields.sourceImage, samples.values, kLowestHu, kHighestHu));
    }
  }
  return map;
}

}  // namespace

LiverMap registerLivers(const Surface& target, const Surface& source, const NormalisationSettings& settings,
                        const Progress& progress) {
  return registerBoth(target, source, nullptr, settings, progress);
}

LiverMap registerLivers(const Surface& target, const Surface& source, const CtPair& images,
                        const NormalisationSettings& settings, const Progress& progress) {
  return registerBoth(target, source, &images, settings, progress);
}

}  // namespace falciform
