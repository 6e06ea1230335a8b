#include "Logic/Registration/PreparedPreop.h"

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TrianglePlaces.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

namespace {

constexpr Index kSample = 4000;

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
  trianglesAround_ = trianglesOfVertices(preop.triangles, preop.size());
  sample_ = randomRows(preop.size(), kSample);
  coarse_ = CoarseTarget(preop, normals_);
  target_ = std::make_shared<const LabelledTarget>(preop, patchLabels(preop));
}

PreparedPreop::Place PreparedPreop::placeAround(int near, const Vector3d& query) const {
  const Points& points = surface_.points;
  Place place{points.row(near).transpose(), normals_.row(near).transpose()};
  double least = (query - place.point).squaredNorm();
  for (const int* t = trianglesAround_.begin(near); t != trianglesAround_.end(near); ++t) {
    const auto corners = surface_.triangles.row(*t);
    const PlaceOnTriangle found = detail::closestByRegions(
        query, {points.row(corners[0]).transpose(), points.row(corners[1]).transpose(),
                points.row(corners[2]).transpose()});
    if (!(found.squaredDistance < least)) continue;
    least = found.squaredDistance;
    place.point = found.point;
    place.normal = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) place.normal += found.barycentric[k] * normals_.row(corners[k]).transpose();
    place.normal.normalize();
  }
  return place;
}

}  // namespace falciform
