#include "Logic/Registration/PreparedPreop.h"

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TrianglePlaces.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

namespace {

constexpr Index kSample = 4000;
constexpr int kLongestWalk = 20;

const Surface& checked(const Surface& preop) {
  checkSurface(preop, "pre-op surface");
  if (preop.size() < 3)
    throw InputError("pre-op surface has " + std::to_string(preop.size()) +
                     " points; a pose needs at least 3");
  return preop;
}

}  // namespace

PreparedPreop::PreparedPreop(const Surface& preop) : surface_(checked(preop)), modes_(preop) {
  normals_ = vertexNormals(preop);
  areas_ = vertexAreas(preop);
  labelCentroids_ = centroidsByLabel(preop.points, preop.patch);
  packedPoints_ = preop.points;
  packedNormals_ = normals_;
  packedTriangles_ = preop.triangles;
  for (Index t = 0; t < preop.triangles.rows(); ++t) {
    const auto ids = packedTriangles_.row(t);
    slivers_.push_back(isSliver(packedPoints_.row(ids[0]).transpose(), packedPoints_.row(ids[1]).transpose(),
                                packedPoints_.row(ids[2]).transpose()));
  }
  trianglesAround_ = trianglesOfVertices(preop.triangles, preop.size());
  sample_ = randomRows(preop.size(), kSample);
  coarse_ = CoarseTarget(preop, normals_);
  target_ = std::make_shared<const LabelledTarget>(preop, patchLabels(preop));
}

/// A place on a triangle (-1: on a point), and whether it is inside it: then no place nearby is nearer.
struct PreparedPreop::Hit {
  int triangle = -1;
  bool inside = false;
  double squaredDistance = 0;
  Vector3d point, barycentric;
};

PreparedPreop::Hit PreparedPreop::hitOn(int triangle, const Vector3d& query) const {
  const auto ids = packedTriangles_.row(triangle);
  const Corners corners{packedPoints_.row(ids[0]).transpose(), packedPoints_.row(ids[1]).transpose(),
                        packedPoints_.row(ids[2]).transpose(),
                        slivers_[static_cast<std::size_t>(triangle)] != 0};
  const PlaceOnTriangle found = closestPlace(query, corners);
  return {triangle, found.part == TrianglePart::Face, found.squaredDistance, found.point, found.barycentric};
}

PreparedPreop::Hit PreparedPreop::hitAround(int near, const Vector3d& query) const {
  Hit hit;
  hit.point = packedPoints_.row(near).transpose();
  hit.squaredDistance = (query - hit.point).squaredNorm();
  for (const int* t = trianglesAround_.begin(near); t != trianglesAround_.end(near); ++t) {
    const Hit found = hitOn(*t, query);
    if (found.squaredDistance < hit.squaredDistance || hit.triangle < 0) hit = found;
  }
  return hit;
}

int PreparedPreop::cornerAt(const Hit& hit) const {
  Index corner = 0;
  hit.barycentric.maxCoeff(&corner);
  return packedTriangles_(hit.triangle, corner);
}

PreparedPreop::Place PreparedPreop::placeOf(const Hit& hit, int near) const {
  if (hit.triangle < 0) return {hit.point, packedNormals_.row(near).transpose(), -1};
  Vector3d normal = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    normal += hit.barycentric[k] * packedNormals_.row(packedTriangles_(hit.triangle, k)).transpose();
  return {hit.point, normal.normalized(), hit.triangle};
}

PreparedPreop::Place PreparedPreop::placeAround(int near, const Vector3d& query) const {
  return placeOf(hitAround(near, query), near);
}

PreparedPreop::Place PreparedPreop::placeByWalk(const Place& last, int& near, const Vector3d& query) const {
  if (last.triangle < 0) return placeAround(near, query);
  Hit hit = hitOn(last.triangle, query);
  int centre = -1;  // of the ring that has been seen
  for (int step = 0; step < kLongestWalk && !hit.inside && cornerAt(hit) != centre; ++step) {
    centre = cornerAt(hit);
    const Hit further = hitAround(centre, query);
    if (further.squaredDistance < hit.squaredDistance) hit = further;
  }
  near = cornerAt(hit);
  return placeOf(hit, near);
}

}  // namespace falciform
