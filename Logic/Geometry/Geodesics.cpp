#include "Logic/Geometry/Geodesics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

namespace falciform {

namespace {

/// Distance at `c` of a wave that knows its distances at `a` and `b`: the source is unfolded into the
/// triangle's plane, on the far side of ab (Novotni, Klein 2002). Infinite where the straight line from it
/// does not pass through ab.
double acrossTriangle(const Vector3d& a, const Vector3d& b, const Vector3d& c, double atA, double atB) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double length = (b - a).norm();
  if (!(length > 0)) return none;
  const Vector3d along = (b - a) / length;
  // In the plane: a = (0, 0), b = (length, 0), c above the line, the source below it.
  const double sourceX = (atA * atA - atB * atB + length * length) / (2 * length);
  const double below2 = atA * atA - sourceX * sourceX;
  if (below2 < -1e-9 * length * length) return none;  // no such source: the two distances do not meet
  const double sourceY = -std::sqrt(std::max(0.0, below2));
  const double cX = (c - a).dot(along), cY = ((c - a) - cX * along).norm();
  const double height = cY - sourceY;
  const double crossing = height > 0 ? sourceX + (cX - sourceX) * -sourceY / height : sourceX;
  if (crossing < -1e-9 * length || crossing > length * (1 + 1e-9)) return none;
  return std::hypot(cX - sourceX, height);
}

class Wave {
 public:
  Wave(const Surface& surface, const Adjacency& triangles, const Vector3d& seed, double radius,
       const std::function<bool(int)>& isAllowed)
      : surface_(surface), triangles_(triangles), seed_(seed), radius_(radius), isAllowed_(isAllowed) {}

  void start(int seedTriangle) {
    for (int k = 0; k < 3; ++k) {
      const int vertex = surface_.triangles(seedTriangle, k);
      improve(vertex, (at(vertex) - seed_).norm(), std::numeric_limits<double>::infinity());
    }
  }

  void start(const std::vector<int>& seeds) {
    oneSeed_ = false;
    for (const int seed : seeds) improve(seed, 0, 0);
  }

  void run() {
    while (!front_.empty()) {
      const auto [distance, vertex] = front_.top();
      front_.pop();
      if (distance > distance_.at(vertex)) continue;  // has been improved since
      for (const int* t = triangles_.begin(vertex); t != triangles_.end(vertex); ++t) sweep(*t, vertex);
    }
  }

  [[nodiscard]] std::vector<GeodesicPoint> result() const {
    std::vector<GeodesicPoint> found;
    for (const auto& [vertex, distance] : distance_)
      if (distance <= radius_) found.push_back({vertex, distance});
    std::sort(found.begin(), found.end(), [](const GeodesicPoint& x, const GeodesicPoint& y) {
      return x.distance != y.distance ? x.distance < y.distance : x.vertex < y.vertex;
    });
    return found;
  }

 private:
  [[nodiscard]] Vector3d at(int vertex) const { return surface_.points.row(vertex); }

  /// Carries the wave from `vertex` over one of its triangles.
  void sweep(int triangle, int vertex) {
    std::array<int, 2> others{};
    int count = 0;
    for (int k = 0; k < 3; ++k)
      if (surface_.triangles(triangle, k) != vertex && count < 2)
        others[static_cast<std::size_t>(count++)] = surface_.triangles(triangle, k);
    if (count < 2) return;  // two equal corners
    const Vector3d p = at(vertex), q = at(others[0]), r = at(others[1]);
    const double longest = std::max({(p - q).norm(), (q - r).norm(), (r - p).norm()});
    const double here = distance_.at(vertex);
    improve(others[0], here + (q - p).norm(), longest);
    improve(others[1], here + (r - p).norm(), longest);
    if (const auto known = distance_.find(others[0]); known != distance_.end())
      improve(others[1], acrossTriangle(p, q, r, here, known->second), longest);
    if (const auto known = distance_.find(others[1]); known != distance_.end())
      improve(others[0], acrossTriangle(p, r, q, here, known->second), longest);
  }

  /// Takes a shorter distance. The wave runs one triangle past the radius, because a vertex within it may be
  /// reached straight only between two of which one is beyond.
  void improve(int vertex, double distance, double margin) {
    if (!(distance <= radius_ + margin)) return;
    // No way is shorter than the straight one.
    if (oneSeed_) distance = std::max(distance, (at(vertex) - seed_).norm());
    const auto known = distance_.find(vertex);
    if (known == distance_.end()) {
      if (isAllowed_ && !isAllowed_(vertex)) return;
      distance_.emplace(vertex, distance);
    } else {
      if (!(distance < known->second - 1e-12 * radius_)) return;
      known->second = distance;
    }
    front_.emplace(distance, vertex);
  }

  using Entry = std::pair<double, int>;
  const Surface& surface_;
  const Adjacency& triangles_;
  Vector3d seed_;
  bool oneSeed_ = true;
  double radius_;
  const std::function<bool(int)>& isAllowed_;
  std::unordered_map<int, double> distance_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front_;
};

}  // namespace

std::vector<GeodesicPoint> withinGeodesicRadius(const Surface& surface, const Adjacency& trianglesOfVertex,
                                                int seedTriangle, const Vector3d& seed, double radius,
                                                const std::function<bool(int)>& isAllowed) {
  if (!(radius > 0) || seedTriangle < 0 || seedTriangle >= surface.triangles.rows()) return {};
  Wave wave(surface, trianglesOfVertex, seed, radius, isAllowed);
  wave.start(seedTriangle);
  wave.run();
  return wave.result();
}

std::vector<GeodesicPoint> withinGeodesicRadius(const Surface& surface, const Adjacency& trianglesOfVertex,
                                                int seedTriangle, const Vector3d& seed, double radius,
                                                const std::vector<char>& allowed) {
  const std::function<bool(int)> isAllowed = allowed.empty() ? std::function<bool(int)>() : [&](int vertex) {
    return allowed[static_cast<std::size_t>(vertex)] != 0;
  };
  return withinGeodesicRadius(surface, trianglesOfVertex, seedTriangle, seed, radius, isAllowed);
}

std::vector<GeodesicPoint> withinGeodesicRadius(const Surface& surface, const Adjacency& trianglesOfVertex,
                                                const std::vector<int>& seeds, double radius) {
  if (!(radius >= 0)) return {};
  const std::function<bool(int)> all;
  Wave wave(surface, trianglesOfVertex, Vector3d::Zero(), radius, all);
  wave.start(seeds);
  wave.run();
  return wave.result();
}

}  // namespace falciform
