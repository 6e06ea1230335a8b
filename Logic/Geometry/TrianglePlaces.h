#pragma once
#include <cmath>

#include "Logic/Core/Types.h"

namespace falciform {

// One triangle against one point or ray: the innermost loops of TriangleTree, inline for speed.

/// The part of a triangle on which a closest place lies, for the choice of its pseudonormal.
enum class TrianglePart { Face, EdgeAb, EdgeBc, EdgeCa, CornerA, CornerB, CornerC };

struct PlaceOnTriangle {
  double squaredDistance = 0;  ///< mm^2
  Vector3d point, barycentric;
  TrianglePart part = TrianglePart::Face;
};

/// Three corners, and whether they are so nearly in line that the face's own equations lose their digits.
struct Corners {
  Vector3d a, b, c;
  bool sliver = false;
};

/// True when the height over the longest edge is less than a thousandth of it (or the triangle has no area).
[[nodiscard]] inline bool isSliver(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});  // mm^2
  return !((b - a).cross(c - a).squaredNorm() > 1e-6 * longest * longest);
}

namespace detail {

inline PlaceOnTriangle placeAt(const Vector3d& query, const Corners& t, double v, double w,
                               TrianglePart part) {
  PlaceOnTriangle place;
  place.barycentric = Vector3d(1 - v - w, v, w);
  place.point = t.a + v * (t.b - t.a) + w * (t.c - t.a);
  place.squaredDistance = (query - place.point).squaredNorm();
  place.part = part;
  return place;
}

inline PlaceOnTriangle cornerPlace(const Vector3d& query, const Corners& t, int corner) {
  PlaceOnTriangle place;
  place.barycentric = Vector3d::Unit(corner);
  place.point = corner == 0 ? t.a : corner == 1 ? t.b : t.c;
  place.squaredDistance = (query - place.point).squaredNorm();
  place.part = static_cast<TrianglePart>(static_cast<int>(TrianglePart::CornerA) + corner);
  return place;
}

/// Closest place by Voronoi regions (Ericson 2005, Real-Time Collision Detection, 5.1.5).
inline PlaceOnTriangle closestByRegions(const Vector3d& query, const Corners& t) {
  const Vector3d ab = t.b - t.a, ac = t.c - t.a, ap = query - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return cornerPlace(query, t, 0);
  const Vector3d bp = query - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return cornerPlace(query, t, 1);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return placeAt(query, t, d1 / (d1 - d3), 0, TrianglePart::EdgeAb);
  const Vector3d cp = query - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cornerPlace(query, t, 2);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return placeAt(query, t, 0, d2 / (d2 - d6), TrianglePart::EdgeCa);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return placeAt(query, t, 1 - w, w, TrianglePart::EdgeBc);
  }
  const double sum = va + vb + vc;
  return placeAt(query, t, vb / sum, vc / sum, TrianglePart::Face);
}

/// Closest place of the edge from corner `from` to the next one.
inline PlaceOnTriangle closestOnEdge(const Vector3d& query, const Corners& t, int from) {
  const Vector3d& p = from == 0 ? t.a : from == 1 ? t.b : t.c;
  const Vector3d& q = from == 0 ? t.b : from == 1 ? t.c : t.a;
  const double length2 = (q - p).squaredNorm();
  const double s = length2 > 0 ? (query - p).dot(q - p) / length2 : 0;
  if (!(s > 0)) return cornerPlace(query, t, from);
  if (s >= 1) return cornerPlace(query, t, (from + 1) % 3);
  PlaceOnTriangle place;
  place.barycentric.setZero();
  place.barycentric[from] = 1 - s;
  place.barycentric[(from + 1) % 3] = s;
  place.point = p + s * (q - p);
  place.squaredDistance = (query - place.point).squaredNorm();
  place.part = static_cast<TrianglePart>(static_cast<int>(TrianglePart::EdgeAb) + from);
  return place;
}

/// On a sliver the regions are decided by rounding, so the best of all edges and the face is taken.
inline PlaceOnTriangle closestOnSliver(const Vector3d& query, const Corners& t) {
  PlaceOnTriangle best = closestOnEdge(query, t, 0);
  for (const int from : {1, 2}) {
    const PlaceOnTriangle edge = closestOnEdge(query, t, from);
    if (edge.squaredDistance < best.squaredDistance) best = edge;
  }
  const PlaceOnTriangle face = closestByRegions(query, t);
  const bool inside = face.barycentric.minCoeff() >= 0 && face.barycentric.maxCoeff() <= 1;  // false for NaN
  return inside && face.squaredDistance < best.squaredDistance ? face : best;
}

}  // namespace detail

/// Closest place of the triangle to `query`.
[[nodiscard]] inline PlaceOnTriangle closestPlace(const Vector3d& query, const Corners& t) {
  return t.sliver ? detail::closestOnSliver(query, t) : detail::closestByRegions(query, t);
}

/// Distance along the unit `direction` to the triangle, from either side; NaN for a miss (Moeller, Trumbore
/// 1997). Edges reach out by a billionth of the triangle, so that a ray through a shared edge finds one of
/// its two sides.
[[nodiscard]] inline double rayDistance(const Vector3d& origin, const Vector3d& direction, const Corners& t) {
  constexpr double miss = std::numeric_limits<double>::quiet_NaN(), slack = 1e-9;
  const Vector3d ab = t.b - t.a, ac = t.c - t.a, p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (!(std::abs(determinant) > 1e-14 * ab.norm() * ac.norm())) return miss;
  const Vector3d s = origin - t.a, q = s.cross(ab);
  const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
  if (u < -slack || v < -slack || u + v > 1 + slack) return miss;
  const double distance = ac.dot(q) / determinant;
  return distance >= 0 ? distance : miss;
}

}  // namespace falciform
