#include <algorithm>
#include <cmath>
#include <limits>

#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Geodesics.h"

namespace falciform {
namespace {

constexpr double kSameWay = 0.77;  // cosine of 40 degrees
constexpr int kRounds = 20;        // of moving to the middle; the sites stand still long before

std::vector<int> undersides(const SupportSites& sites) {
  std::vector<int> faces = sites.leftUnderside;
  faces.insert(faces.end(), sites.rightUnderside.begin(), sites.rightUnderside.end());
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The face of `faces` whose centre is nearest; the lowest number on a tie.
int nearestFace(const SupportSites& sites, const std::vector<int>& faces, const Vector3d& place) {
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int f : faces) {
    const double d = (sites.centres.row(f).transpose() - place).squaredNorm();
    if (d < least) least = d, best = f;
  }
  return best;
}

std::vector<int> farthestFaces(const SupportSites& sites, const std::vector<int>& faces, int count) {
  std::vector<int> chosen{nearestFace(sites, faces, centreOf(sites, faces))};
  std::vector<double> distance(faces.size(), std::numeric_limits<double>::infinity());
  while (static_cast<int>(chosen.size()) < count) {
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      distance[i] = std::min(distance[i],
                             (sites.centres.row(faces[i]) - sites.centres.row(chosen.back())).squaredNorm());
      if (distance[i] > distance[farthest]) farthest = i;
    }
    chosen.push_back(faces[farthest]);
  }
  return chosen;
}

/// Outward, as long as twice the area.
Vector3d normalOf(const SupportSites& sites, int face) {
  const Surface& surface = sites.boundary.surface;
  const auto corner = [&](int k) {
    return Vector3d(surface.points.row(surface.triangles(face, k)).transpose());
  };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

/// A towel pushes one way: without what lies around a margin, whose normals would press the tissue together.
std::vector<int> lookingAlike(const SupportSites& sites, const std::vector<int>& faces, int seed) {
  Vector3d mean = Vector3d::Zero();
  for (const int f : faces) mean += normalOf(sites, f);
  mean.normalize();
  std::vector<int> kept;
  for (const int f : faces)
    if (f == seed || normalOf(sites, f).normalized().dot(mean) > kSameWay) kept.push_back(f);
  return kept;
}

}  // namespace

std::vector<int> packingSite(const SupportSites& sites, const Vector3d& centre, double radiusMm) {
  return packingSite(sites, centre, radiusMm, undersides(sites));
}

std::vector<int> packingSite(const SupportSites& sites, const Vector3d& centre, double radiusMm,
                             const std::vector<int>& faces) {
  if (!(radiusMm > 0))
    throw InputError("the extent of a packing site is " + std::to_string(radiusMm) +
                     " mm; give a radius above 0");
  if (faces.empty()) throw InputError("there is no face to pack against");
  const Surface& surface = sites.boundary.surface;
  const int seed = nearestFace(sites, faces, centre);
  std::vector<char> allowed(static_cast<std::size_t>(surface.size()), 0);
  for (const int f : faces)
    for (int k = 0; k < 3; ++k) allowed[static_cast<std::size_t>(surface.triangles(f, k))] = 1;
  VectorXd distance = VectorXd::Constant(surface.size(), std::numeric_limits<double>::infinity());
  // A corner beyond the radius may belong to a face whose centre is within it.
  const double reach = radiusMm + std::sqrt(4 * sites.areasMm2.maxCoeff());
  for (const GeodesicPoint& point :
       withinGeodesicRadius(surface, trianglesOfVertices(surface.triangles, surface.size()), seed,
                            sites.centres.row(seed).transpose(), reach, allowed))
    distance(point.vertex) = point.distance;
  std::vector<int> found;
  for (const int f : faces) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += distance(surface.triangles(f, k));
    if (f == seed || sum / 3 <= radiusMm) found.push_back(f);
  }
  return lookingAlike(sites, found, seed);
}

std::vector<Vector3d> packingSites(const SupportSites& sites, int count) {
  const std::vector<int> faces = undersides(sites);
  if (count < 1 || count > static_cast<int>(faces.size()))
    throw InputError(std::to_string(count) + " packing sites were asked for; choose 1 to " +
                     std::to_string(faces.size()) + ", the number of faces on the undersides");
  std::vector<int> chosen = farthestFaces(sites, faces, count);
  // Farthest points crowd at the rims, where nobody packs.
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::vector<int>> nearest(chosen.size());
    for (const int f : faces) {
      const Vector3d place = sites.centres.row(f).transpose();
      std::size_t best = 0;
      for (std::size_t i = 1; i < chosen.size(); ++i)
        if ((sites.centres.row(chosen[i]).transpose() - place).squaredNorm() <
            (sites.centres.row(chosen[best]).transpose() - place).squaredNorm())
          best = i;
      nearest[best].push_back(f);
    }
    std::vector<int> moved;
    for (const std::vector<int>& cell : nearest)
      moved.push_back(nearestFace(sites, cell, centreOf(sites, cell)));
    if (moved == chosen) break;
    chosen = moved;
  }
  std::vector<Vector3d> places;
  for (const int f : chosen) places.emplace_back(sites.centres.row(f).transpose());
  return places;
}

}  // namespace falciform
