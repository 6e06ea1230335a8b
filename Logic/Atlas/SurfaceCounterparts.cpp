#include "Logic/Atlas/SurfaceCounterparts.h"

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/TrianglePlaces.h"

namespace falciform {
namespace {

constexpr double kStaleMm = 0.25;  ///< edges are ten times as long
constexpr std::size_t kChunk = 256;

}  // namespace

Points placesOf(const std::vector<Counterpart>& counterparts, const Points& points) {
  Points places(static_cast<Index>(counterparts.size()), 3);
  for (std::size_t j = 0; j < counterparts.size(); ++j) {
    const Counterpart& c = counterparts[j];
    places.row(static_cast<Index>(j)) = c.shares.transpose() * points(c.vertices, Eigen::all);
  }
  return places;
}

CounterpartSearch::CounterpartSearch(const Surface& surface, bool patches, double correspondenceWeight)
    : correspondenceWeight_(correspondenceWeight),
      triangles_(trianglesOfVertices(surface.triangles, surface.size())) {
  surface_.points = surface.points;
  surface_.triangles = surface.triangles;
  surface_.patch = surface.patch;
  if (patches) labels_ = patchLabels(surface);
  target_.emplace(surface_, labels_);
}

void CounterpartSearch::moveTo(const Points& points) {
  surface_.points = points;
  const double moved = (points - target_->points()).rowwise().squaredNorm().maxCoeff();
  if (moved > kStaleMm * kStaleMm) target_.emplace(surface_, labels_);
}

Counterpart CounterpartSearch::around(const Vector3d& query, int vertex, int label) const {
  Counterpart best{Eigen::Vector3i::Constant(vertex)};
  double distance = squaredDistance(query, surface_.points.row(vertex).transpose());
  const bool labelled = label > 0 && surface_.patchAt(vertex) == label;
  for (const int* t = triangles_.begin(vertex); t != triangles_.end(vertex); ++t) {
    const Eigen::Vector3i ids = surface_.triangles.row(*t).transpose();
    if (labelled && (surface_.patchAt(ids[0]) != label || surface_.patchAt(ids[1]) != label ||
                     surface_.patchAt(ids[2]) != label))
      continue;
    Corners corners{surface_.points.row(ids[0]), surface_.points.row(ids[1]), surface_.points.row(ids[2])};
    corners.sliver = isSliver(corners.a, corners.b, corners.c);
    const PlaceOnTriangle place = closestPlace(query, corners);
    if (!(place.squaredDistance < distance)) continue;
    distance = place.squaredDistance;
    best = {ids, place.barycentric};
  }
  return best;
}

std::vector<Counterpart> CounterpartSearch::find(const Points& points, const std::vector<int>& labels) {
  std::vector<Counterpart> found(labels.size());
  guesses_.resize(labels.size(), -1);
  forEachChunk(labels.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t j = first; j < last; ++j) {
      const Vector3d query = points.row(static_cast<Index>(j)).transpose();
      const int label = uses(labels[j]) ? labels[j] : 0;
      guesses_[j] = target_->closest(query, label, correspondenceWeight_, guesses_[j]).index;  // Eq. (III.1)
      found[j] = around(query, guesses_[j], label);
    }
  });
  return found;
}

}  // namespace falciform
