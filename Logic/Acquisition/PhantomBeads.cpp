#include "Logic/Acquisition/PhantomBeads.h"

#include <limits>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr int kCandidates = 20;
constexpr int kMaxDraws = 100000;  // of one candidate: the liver fills a quarter of its box

Vector3d drawnInside(const LiverShape& liver, double depthMm, Draws& draws) {
  const auto& box = liver.bounds();
  for (int attempt = 0; attempt < kMaxDraws; ++attempt) {
    Vector3d place;
    for (int axis = 0; axis < 3; ++axis) place[axis] = draws.uniform(box(0, axis), box(1, axis));
    if (liver.distance(place) <= -depthMm) return place;
  }
  throw InputError("no place in the phantom is " + std::to_string(depthMm) +
                   " mm deep; take less depth over the beads");
}

double squaredGap(const Landmarks& beads, const Vector3d& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const Landmark& bead : beads.points) least = std::min(least, (bead.position - place).squaredNorm());
  return least;
}

}  // namespace

Landmarks placeBeads(const LiverShape& liver, const PhantomBeadPlan& plan) {
  if (plan.count < 1)
    throw InputError("a phantom with " + std::to_string(plan.count) +
                     " beads has no targets; take 1 or more");
  Draws draws(plan.seed, 43);
  Landmarks beads;
  for (int b = 1; b <= plan.count; ++b) {
    Vector3d best = drawnInside(liver, plan.depthMm, draws);
    for (int c = 1; c < kCandidates; ++c) {
      const Vector3d place = drawnInside(liver, plan.depthMm, draws);
      if (squaredGap(beads, place) > squaredGap(beads, best)) best = place;
    }
    beads.points.push_back({"bead " + std::to_string(b), best});
  }
  return beads;
}

}  // namespace falciform
