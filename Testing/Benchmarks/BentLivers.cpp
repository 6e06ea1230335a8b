#include "Testing/Benchmarks/BentLivers.h"

#include <stdexcept>
#include "Logic/Core/LandmarkPairs.h"

#include "Logic/Acquisition/SyntheticDeformation.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform::bench {

namespace {

constexpr std::size_t kLeastPatchPoints = 30;
constexpr int kViews = 50;           // drawn at most
constexpr int kAimStride = 3;        // while aiming
constexpr double kVariation = 0.15;  // of the shape

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

std::vector<Station> BentLiver::aim(double visibleShare) const {
  Draws draws(static_cast<std::uint64_t>(seed_), 11);
  for (int attempt = 0; attempt < kViews; ++attempt) {
    std::vector<Station> stations = aimStations(after_.surface, visibleShare, draws);
    const Surface scan = scanFrom(stations, after_.surface, 0, kAimStride, seed_).scan;
    if (pointsOfPatch(scan, patch::kFalciform).size() >= kLeastPatchPoints &&
        pointsOfPatch(scan, patch::kInferiorRidge).size() >= kLeastPatchPoints)
      return stations;
  }
  throw std::runtime_error("no view of liver " + std::to_string(seed_) + " shows both patches");
}

BenchCase BentLiver::seen(const std::vector<Station>& stations, double noiseMm, int stride) const {
  VirtualScan scan = scanFrom(stations, after_.surface, noiseMm, stride, seed_);
  BenchCase c;
  c.name = "bent liver " + std::to_string(seed_);
  c.preop = before_.surface;
  c.scan = std::move(scan.scan);
  c.targetsPreop = positionsOf(before_.targets);
  c.targetsScan = transformed(positionsOf(after_.targets), scan.scanFromPreop);
  c.bestRigid = fitRigid(c.targetsPreop, c.targetsScan);
  c.optimalMm = targetErrorMm(c, c.bestRigid);
  c.limitMm = 1.4 * c.optimalMm + 1;
  c.coverage = scan.coverage;
  addNormals(c);
  return c;
}

}  // namespace falciform::bench
