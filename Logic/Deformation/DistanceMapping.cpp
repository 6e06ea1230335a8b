#include "Logic/Deformation/DistanceMapping.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/SurfaceBorder.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

Vector3d rowOf(const Points& points, Index i) {
  return points.rows() > 0 ? Vector3d(points.row(i)) : Vector3d::Zero();
}

/// Normals of the scan: as measured, else of its triangles, else none.
Points scanNormals(const Surface& scan) {
  if (scan.normals.rows() == scan.size()) return scan.normals;
  return scan.triangles.rows() > 0 ? vertexNormals(scan) : Points(0, 3);
}

/// Everything that both directions of the measurement ask.
class Comparison {
 public:
  Comparison(const Surface& preop, const Surface& scan, const DistanceSettings& settings)
      : preop_(preop),
        scan_(scan),
        reach_(settings.reachMm),
        leastCosine_(std::cos(settings.normalLimitDeg * std::numbers::pi / 180)),
        preopNormals_(vertexNormals(preop)),
        scanNormals_(scanNormals(scan)),
        preopTree_(preop),
        preopBorder_(preop) {
    if (scan.triangles.rows() > 0) {
      scanTree_.emplace(scan);
      scanBorder_.emplace(scan);
    } else {
      scanCloud_ = KdTree(scan.points);
      cloudBorder_.emplace(scanCloud_, scan.points);
    }
  }

  /// Distance of a scan point to the pre-op surface, point to triangle; + outside.
  [[nodiscard]] double atScanPoint(Index i) const {
    const Vector3d point = scan_.points.row(i), normal = rowOf(scanNormals_, i);
    const ClosestPlace place = preopTree_.closest(point, reach_);
    if (place.triangle < 0) return kNoValue;
    const Vector3d preopNormal = normalAt(preopTree_, preopNormals_, place);
    if (opposed(normal, preopNormal)) return kNoValue;
    if (preopBorder_.holds(place.triangle, place.barycentric) &&
        leadsAside(point - place.point, normal, preopNormal))
      return kNoValue;
    return place.side * place.distance;
  }

  /// Distance of a pre-op vertex to the scan; + where the scan lies on the outer side of the vertex.
  [[nodiscard]] double atPreopVertex(Index i) const {
    const Vector3d vertex = preop_.points.row(i), normal = preopNormals_.row(i);
    if (normal.squaredNorm() == 0) return kNoValue;  // a point of no triangle has no outside
    return scanTree_ ? toTriangles(vertex, normal) : toPoints(vertex, normal);
  }

 private:
  static Vector3d normalAt(const TriangleTree& tree, const Points& normals, const ClosestPlace& place) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      sum += place.barycentric[k] * normals.row(tree.vertexOf(place.triangle, k)).transpose();
    return sum.stableNormalized();
  }

  /// Zero normals are not known, and oppose nothing.
  [[nodiscard]] bool opposed(const Vector3d& a, const Vector3d& b) const {
    return a.squaredNorm() > 0 && b.squaredNorm() > 0 && !(a.dot(b) > leastCosine_);
  }

  [[nodiscard]] double toTriangles(const Vector3d& vertex, const Vector3d& normal) const {
    const ClosestPlace place = scanTree_->closest(vertex, reach_);
    if (place.triangle < 0) return kNoValue;
    const Vector3d scanNormal = normalAt(*scanTree_, scanNormals_, place), offset = place.point - vertex;
    if (opposed(normal, scanNormal)) return kNoValue;
    if (scanBorder_->holds(place.triangle, place.barycentric) && leadsAside(offset, normal, scanNormal))
      return kNoValue;
    return offset.dot(normal) < 0 ? -place.distance : place.distance;
  }

  [[nodiscard]] double toPoints(const Vector3d& vertex, const Vector3d& normal) const {
    const std::vector<Neighbour> nearest = scanCloud_.nearest(vertex, 6);
    const double distance = std::sqrt(nearest.front().squaredDistance);
    if (distance > reach_) return kNoValue;
    const int first = nearest.front().index;
    const ClosestPlace back = preopTree_.closest(scan_.points.row(first).transpose(), distance);
    if (back.distance < 0.5 * distance && distance > 1.5 * cloudBorder_->spacingAt(first))
      return kNoValue;  // the point belongs to another place of the surface, through a thin lobe or across a
                        // fold
    if (opposed(normal, cloudNormal(first, back))) return kNoValue;
    if (cloudBorder_->isPassed(vertex, normal, first)) return kNoValue;
    // Near contact the nearest point may lie a spacing aside, its height mere noise: the points around it
    // vote.
    double height = 0;
    for (const Neighbour& neighbour : nearest)
      height += (scan_.points.row(neighbour.index).transpose() - vertex).dot(normal);
    return height < 0 ? -distance : distance;
  }

  /// A cloud without normals is taken to face as the pre-op surface nearest to it, at `back`, does: so that a
  /// scan of one side of a thin lobe does not cover the other.
  [[nodiscard]] Vector3d cloudNormal(int point, const ClosestPlace& back) const {
    if (scanNormals_.rows() > 0) return scanNormals_.row(point);
    return back.triangle < 0 ? Vector3d::Zero() : normalAt(preopTree_, preopNormals_, back);
  }

  const Surface& preop_;
  const Surface& scan_;
  double reach_, leastCosine_;
  Points preopNormals_, scanNormals_;
  TriangleTree preopTree_;
  SurfaceBorder preopBorder_;
  std::optional<TriangleTree> scanTree_;
  std::optional<SurfaceBorder> scanBorder_;
  KdTree scanCloud_;
  std::optional<CloudBorder> cloudBorder_;
};

/// Values of `count` items, on all threads, with progress between blocks.
VectorXd measureAll(Index count, const std::function<double(Index)>& measure, const Progress& progress,
                    std::string_view stage) {
  constexpr Index block = 16384;
  constexpr std::size_t chunk = 256;
  VectorXd values(count);
  for (Index from = 0; from < count; from += block) {
    progress.report(static_cast<double>(from) / static_cast<double>(count), stage);
    const Index to = std::min(count, from + block);
    forEachChunk(static_cast<std::size_t>(to - from), chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index item = from + static_cast<Index>(i);
        values[item] = measure(item);
      }
    });
  }
  progress.report(1, stage);
  return values;
}

std::map<int, DistanceStatistics> statisticsByPatch(const Surface& surface, const VectorXd& values) {
  std::map<int, DistanceStatistics> byPatch;
  for (const int label : patchLabels(surface))
    byPatch[label] = distanceStatistics(values(pointsOfPatch(surface, label)));
  return byPatch;
}

double coveredShare(const Surface& surface, const VectorXd& values) {
  const VectorXd areas = vertexAreas(surface);
  double covered = 0, whole = 0;
  for (Index i = 0; i < areas.size(); ++i) {
    whole += areas[i];
    covered += std::isnan(values[i]) ? 0 : areas[i];  // in the same order, so that all of it is exactly 1
  }
  return whole > 0 ? covered / whole : 0;
}

}  // namespace

DistanceMap mapDistances(const Surface& preop, const Surface& scan, const Isometry3d& scanFromPreop,
                         const DistanceSettings& settings, const Progress& progress) {
  checkSettings(settings);
  if (preop.triangles.rows() == 0)
    throw InputError("the pre-operative surface has no triangles; import it as a surface, not as a cloud");
  if (scan.size() == 0) throw InputError("the scan has no points; open another scan");
  if (!scanFromPreop.matrix().allFinite())
    throw InputError("the registration holds a value that is not a number; register again");

  progress.report(0, "Preparing surfaces");
  DistanceMap map;
  map.preop = transformed(preop, scanFromPreop, scan.frame);
  map.scan = scan;
  const Comparison comparison(map.preop, map.scan, settings);
  VectorXd atPreop = measureAll(
      preop.size(), [&](Index i) { return comparison.atPreopVertex(i); }, progress.part(0.1, 0.55),
      "Measuring from the pre-operative surface");
  VectorXd atScan = measureAll(
      scan.size(), [&](Index i) { return comparison.atScanPoint(i); }, progress.part(0.55, 1),
      "Measuring from the scan");

  map.preopAll = distanceStatistics(atPreop);
  map.scanAll = distanceStatistics(atScan);
  map.preopByPatch = statisticsByPatch(map.preop, atPreop);
  map.scanByPatch = statisticsByPatch(map.scan, atScan);
  map.coverage = coveredShare(map.preop, atPreop);
  map.preop.arrays[kSignedDistance] = std::move(atPreop);
  map.scan.arrays[kSignedDistance] = std::move(atScan);
  return map;
}

}  // namespace falciform
