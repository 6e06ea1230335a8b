#include "Testing/Benchmarks/BentLivers.h"

#include <stdexcept>

#include "Logic/Acquisition/SyntheticDeformation.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform::bench {

namespace {

constexpr std::size_t kLeastPatchPoints = 30;
constexpr int kViews = 50;           // drawn at most
constexpr double kVariation = 0.15;  // of the shape

Points positions(const Landmarks& landmarks) {
  Points points(static_cast<Index>(landmarks.points.size()), 3);
  for (Index i = 0; i < points.rows(); ++i)
    points.row(i) = landmarks.points[static_cast<std::size_t>(i)].position.transpose();
  return points;
}

SyntheticLiver drawLiver(int seed, double edgeLengthMm) {
  SyntheticLiverSettings shape;
  shape.edgeLengthMm = edgeLengthMm;
  shape.variation = kVariation;
  shape.seed = seed;
  return makeSyntheticLiver(shape);
}

SyntheticLiver bent(const SyntheticLiver& liver, int seed, double rmsMm) {
  SyntheticDeformationSettings bending;
  bending.rmsMm = rmsMm;
  bending.seed = seed;
  return deformSynthetic(liver, bending);
}

}  // namespace

BentLiver::BentLiver(int seed, double bendingRmsMm, double edgeLengthMm)
    : seed_(seed), before_(drawLiver(seed, edgeLengthMm)), after_(bent(before_, seed, bendingRmsMm)) {}

BenchCase BentLiver::seen(const AimedView& view) const {
  Draws draws(static_cast<std::uint64_t>(seed_), 11);
  for (int attempt = 0; attempt < kViews; ++attempt) {
    VirtualScan scan = scanAimed(after_.surface, view, seed_, draws);
    if (pointsOfPatch(scan.scan, patch::kFalciform).size() < kLeastPatchPoints ||
        pointsOfPatch(scan.scan, patch::kInferiorRidge).size() < kLeastPatchPoints)
      continue;
    BenchCase c;
    c.name = "bent liver " + std::to_string(seed_);
    c.preop = before_.surface;
    c.scan = std::move(scan.scan);
    c.targetsPreop = positions(before_.targets);
    c.targetsScan = transformed(positions(after_.targets), scan.scanFromPreop);
    c.bestRigid = fitRigid(c.targetsPreop, c.targetsScan);
    c.optimalMm = targetErrorMm(c, c.bestRigid);
    c.limitMm = 1.4 * c.optimalMm + 1;
    c.coverage = scan.coverage;
    addNormals(c);
    return c;
  }
  throw std::runtime_error("no view of liver " + std::to_string(seed_) + " shows both patches");
}

}  // namespace falciform::bench
