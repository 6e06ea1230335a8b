#include "Logic/Biomechanics/SupportSites.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {
namespace {

constexpr double kNeighbourhoodMm = 12;  // wider than fissures and the elements' own roughness
constexpr double kSmallPiece = 0.1;      // share of a region's area below which a separate piece is noise

/// What the regions are told apart by.
struct Outlook {
  Points normals;  ///< F x 3 unit, mean of the neighbourhood that faces the same way
  VectorXd left;   ///< F, mm from the groove's plane
  Vector3d size;   ///< of the liver's box, mm
};

Outlook outlook(const SupportSites& sites, const BoundaryFaces& faces) {
  Outlook result{.normals = faces.areaVectors, .left = VectorXd(faces.size()), .size = Vector3d::Zero()};
  const KdTree tree(sites.centres);
  forEachChunk(static_cast<std::size_t>(faces.size()), 256, [&](std::size_t begin, std::size_t end) {
    for (auto f = static_cast<Index>(begin); f < static_cast<Index>(end); ++f) {
      const Vector3d centre = sites.centres.row(f).transpose(), own = faces.areaVectors.row(f).transpose();
      Vector3d sum = Vector3d::Zero();
      for (const int other : tree.within(centre, kNeighbourhoodMm)) {
        const Vector3d area = faces.areaVectors.row(other).transpose();
        if (area.dot(own) > 0) sum += area;  // the far side of a thin edge looks elsewhere
      }
      result.normals.row(f) = sum.normalized().transpose();
      result.left(f) = sites.groove.leftOf(centre);
    }
  });
  result.size = (sites.boundary.surface.points.colwise().maxCoeff() -
                 sites.boundary.surface.points.colwise().minCoeff())
                    .transpose();
  return result;
}

/// Faces joined by vertices, pieces smaller than a share of the region's area dropped.
std::vector<int> withoutCrumbs(const SupportSites& sites, const Adjacency& facesOfVertex,
                               const std::vector<int>& region, double smallest = kSmallPiece) {
  std::vector<int> piece(static_cast<std::size_t>(sites.centres.rows()), -2);
  for (const int f : region) piece[static_cast<std::size_t>(f)] = -1;
  std::vector<double> areas;
  for (const int first : region) {
    if (piece[static_cast<std::size_t>(first)] != -1) continue;
    const int number = static_cast<int>(areas.size());
    areas.push_back(0);
    std::vector<int> open{first};
    piece[static_cast<std::size_t>(first)] = number;
    while (!open.empty()) {
      const int f = open.back();
      open.pop_back();
      areas.back() += sites.areasMm2(f);
      for (int k = 0; k < 3; ++k) {
        const int v = sites.boundary.surface.triangles(f, k);
        for (const int* next = facesOfVertex.begin(v); next != facesOfVertex.end(v); ++next)
          if (piece[static_cast<std::size_t>(*next)] == -1)
            piece[static_cast<std::size_t>(*next)] = number, open.push_back(*next);
      }
    }
  }
  double total = 0;
  for (const double area : areas) total += area;
  std::vector<int> kept;
  for (const int f : region)
    if (areas[static_cast<std::size_t>(piece[static_cast<std::size_t>(f)])] >= smallest * total)
      kept.push_back(f);
  return kept;
}

/// How deep a face lies in a hollow that runs head to foot, mm: behind it the organ comes further back on
/// both sides within `reach`, at about the same height.
double hollowMm(const SupportSites& sites, const std::vector<int>& back, const Vector3d& place,
                double reach) {
  double left = 0, right = 0;
  for (const int f : back) {
    const Vector3d d = sites.centres.row(f).transpose() - place;
    if (std::abs(d.z()) > kNeighbourhoodMm || std::abs(d.x()) > reach) continue;
    double& side = d.x() > 0 ? left : right;
    side = std::max(side, d.y());
  }
  return std::min(left, right);
}

/// The vena cava runs head to foot behind the liver's upper half, on average 15 mm to the right of the
/// groove's plane, and often in a hollow of its own between caudate and right lobe: an upright oval about the
/// place that fits this best.
std::vector<int> aroundVenaCava(const SupportSites& sites, const Outlook& look) {
  std::vector<int> back, beside;
  for (Index f = 0; f < sites.centres.rows(); ++f) {
    if (look.normals(f, 1) < 0.2) continue;
    back.push_back(static_cast<int>(f));
    if (std::abs(look.left(f) + 0.07 * look.size.x()) < 0.18 * look.size.x()) beside.push_back(back.back());
  }
  double top = -std::numeric_limits<double>::infinity(), bottom = -top, hindmost = top;
  for (const int f : beside) {
    top = std::max(top, sites.centres(f, 2));
    bottom = std::min(bottom, sites.centres(f, 2));
    hindmost = std::max(hindmost, sites.centres(f, 1));
  }
  Vector3d centre = Vector3d::Zero();
  double weight = 0;
  for (const int f : beside) {
    const double height = (sites.centres(f, 2) - bottom) / (top - bottom);
    if (height < 0.4) continue;
    const double aside = (look.left(f) + 0.07 * look.size.x()) / (0.08 * look.size.x());
    const double hollow = hollowMm(sites, back, sites.centres.row(f).transpose(), 0.2 * look.size.x());
    const double behind = (sites.centres(f, 1) - hindmost) / (0.15 * look.size.y());
    const double w = sites.areasMm2(f) * std::exp(behind - aside * aside / 2) * (2 + std::min(hollow, 20.0));
    centre += w * sites.centres.row(f).transpose();
    weight += w;
  }
  std::vector<int> found;
  if (weight == 0) return found;
  centre /= weight;
  for (const int f : beside) {
    const Vector3d d = sites.centres.row(f).transpose() - centre;
    const double across = d.x() / (0.10 * look.size.x()), along = d.z() / (0.20 * look.size.z());
    if (across * across + along * along <= 1 && d.y() > -0.15 * look.size.y()) found.push_back(f);
  }
  return found;
}

}  // namespace

SupportSites findSupportSites(const Surface& preop, const TetrahedralMesh& mesh, const BoundaryFaces& faces) {
  SupportSites sites;
  sites.groove = groovePlane(preop);
  if (!sites.groove.painted)
    sites.warnings.push_back(
        "no falciform patch is painted: the lobes are parted at the middle of the liver's box; paint the "
        "groove for a better place");
  sites.boundary = boundarySurface(mesh, faces);
  sites.areasMm2 = faces.areaVectors.rowwise().norm();
  sites.centres = faceCentres(mesh, faces);

  const Outlook look = outlook(sites, faces);
  const Adjacency facesOfVertex =
      trianglesOfVertices(sites.boundary.surface.triangles, sites.boundary.surface.size());
  sites.venaCava = withoutCrumbs(sites, facesOfVertex, aroundVenaCava(sites, look), 0.4);
  std::vector<char> taken(static_cast<std::size_t>(faces.size()), 0);
  for (const int f : sites.venaCava) taken[static_cast<std::size_t>(f)] = 1;
  for (Index f = 0; f < faces.size(); ++f) {
    if (taken[static_cast<std::size_t>(f)]) continue;
    const double back = look.normals(f, 1), down = -look.normals(f, 2);
    if (look.left(f) > 0) {
      // The left lobe lies on the stomach, behind and below it: both ways count.
      if (back > -0.3 && back + down > 0.5) sites.leftUnderside.push_back(static_cast<int>(f));
    } else if (down > 0.35) {
      if (back > -0.3) sites.rightUnderside.push_back(static_cast<int>(f));
    } else if (back > 0.4) {
      sites.posteriorBed.push_back(static_cast<int>(f));
    }
  }
  for (std::vector<int>* region : {&sites.posteriorBed, &sites.leftUnderside, &sites.rightUnderside})
    *region = withoutCrumbs(sites, facesOfVertex, *region);

  const std::pair<const char*, const std::vector<int>*> regions[] = {
      {"vena cava", &sites.venaCava},
      {"posterior bed", &sites.posteriorBed},
      {"underside of the left lobe", &sites.leftUnderside},
      {"underside of the right lobe", &sites.rightUnderside}};
  for (const auto& [name, region] : regions)
    if (region->empty())
      throw InputError(std::string("no place for the support '") + name +
                       "' was found; is the surface a whole liver in patient LPS (x to the left, y to the "
                       "back, z to the head)?");
  return sites;
}

Vector3d centreOf(const SupportSites& sites, const std::vector<int>& faces) {
  Vector3d sum = Vector3d::Zero();
  double area = 0;
  for (const int f : faces) {
    sum += sites.areasMm2(f) * sites.centres.row(f).transpose();
    area += sites.areasMm2(f);
  }
  return area > 0 ? Vector3d(sum / area) : sum;
}

}  // namespace falciform
