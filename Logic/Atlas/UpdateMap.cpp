#include "Logic/Atlas/UpdateMap.h"

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 256;
constexpr int kBroydenSteps = 30, kNewtonSteps = 20;

}  // namespace

UpdateMap::UpdateMap(const TetrahedralMesh& mesh, const Points& displacements,
                     const Isometry3d& scanFromPreop, const ContinuationPlan& plan)
    : plan_(plan),
      scanFromPreop_(scanFromPreop),
      locator_(mesh),
      deformed_(mesh, displacements),
      continuation_(locator_, displacements, plan) {}

Vector3d UpdateMap::bentFromPreop(const Vector3d& preop) const {
  const FieldContinuation::Value smooth = continuation_.at(preop);
  if (!smooth.near) return preop + smooth.displacement;
  const MeshLocator::Place place = locator_.find(preop);
  if (place.outsideMm == 0) return deformed_.now(place.element, place.barycentric);
  const double t = place.outsideMm / plan_.bandMm;
  if (t >= 1) return preop + smooth.displacement;
  const Vector3d foot = deformed_.before(place.element, place.barycentric);
  const Vector3d linear = deformed_.now(place.element, place.barycentric, preop - foot);
  const double own = 1 - t * t * (3 - 2 * t);
  return own * linear + (1 - own) * (preop + smooth.displacement);
}

PreopPlace UpdateMap::preopFromBent(const Vector3d& bent, const PreopPlace* guess, double toleranceMm) const {
  if (const auto tissue = deformed_.find(bent, guess != nullptr ? guess->element : -1))
    return {.preop = tissue->before, .inside = true, .element = tissue->element};
  const Vector3d start = guess != nullptr ? guess->preop : bent - continuation_.at(bent).displacement;
  return invertOutside(bent, start, toleranceMm);
}

PreopPlace UpdateMap::invertOutside(const Vector3d& bent, const Vector3d& start, double toleranceMm) const {
  const auto missAt = [&](const Vector3d& preop) { return Vector3d(bentFromPreop(preop) - bent); };
  Vector3d best = start, bestMiss = missAt(start);
  const auto keepBest = [&](const Vector3d& preop, const Vector3d& miss) {
    if (miss.squaredNorm() >= bestMiss.squaredNorm()) return;
    best = preop;
    bestMiss = miss;
  };
  const auto done = [&] { return bestMiss.norm() <= toleranceMm; };

  // Broyden's good method: one evaluation a step, the inverse slope learnt on the way.
  Vector3d preop = start, miss = bestMiss;
  Matrix3d inverse = Matrix3d::Identity();
  for (int step = 0; step < kBroydenSteps && !done(); ++step) {
    const Vector3d change = -inverse * miss;
    preop += change;
    const Vector3d missNow = missAt(preop), gained = inverse * (missNow - miss);
    const double along = change.dot(gained);
    if (std::abs(along) > 1e-30) inverse += (change - gained) * (change.transpose() * inverse) / along;
    miss = missNow;
    if (!(miss.norm() < 1e6)) break;
    keepBest(preop, miss);
  }
  // From the best so far, Newton's method by differences, halving steps that do not help.
  for (int step = 0; step < kNewtonSteps && !done(); ++step) {
    constexpr double kDifferenceMm = 1e-4;
    Matrix3d slope;
    for (int axis = 0; axis < 3; ++axis)
      slope.col(axis) = (missAt(best + kDifferenceMm * Vector3d::Unit(axis)) - bestMiss) / kDifferenceMm;
    const Vector3d change = slope.fullPivLu().solve(-bestMiss), from = best;
    const double before = bestMiss.norm();
    for (double share = 1; share > 1e-3 && bestMiss.norm() >= before; share /= 2)
      keepBest(from + share * change, missAt(from + share * change));
    if (!(bestMiss.norm() < before)) break;
  }
  return {.preop = best, .missMm = bestMiss.norm()};
}

Points UpdateMap::scanFromPreop(const Points& preop) const {
  Points scan(preop.rows(), 3);
  forEachChunk(static_cast<std::size_t>(preop.rows()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      scan.row(i) = (scanFromPreop_ * bentFromPreop(preop.row(i).transpose())).transpose();
  });
  return scan;
}

std::vector<PreopPlace> UpdateMap::preopFromScan(const Points& scan) const {
  if (!scan.allFinite())
    throw InputError("places to find in the pre-op CT have coordinates that are not finite; remove them");
  std::vector<PreopPlace> places(static_cast<std::size_t>(scan.rows()));
  const Isometry3d bentFromScan = scanFromPreop_.inverse();
  forEachChunk(places.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      places[i] = preopFromBent(bentFromScan * Vector3d(scan.row(static_cast<Index>(i)).transpose()));
      if (!places[i].inside) places[i].outsideMm = locator_.find(places[i].preop).outsideMm;
    }
  });
  return places;
}

}  // namespace falciform
