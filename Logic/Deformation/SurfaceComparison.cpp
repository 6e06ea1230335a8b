#include "Logic/Deformation/SurfaceComparison.h"

#include <cmath>
#include <numbers>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

Vector3d rowOf(const Points& points, Index i) {
  return points.rows() > 0 ? Vector3d(points.row(i)) : Vector3d::Zero();
}

Points normalsOf(const Surface& scan) {
  if (scan.normals.rows() == scan.size()) return scan.normals;
  return scan.triangles.rows() > 0 ? vertexNormals(scan) : Points(0, 3);
}

Vector3d normalAt(const TriangleTree& tree, const Points& normals, const ClosestPlace& place) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    sum += place.barycentric[k] * normals.row(tree.vertexOf(place.triangle, k)).transpose();
  return sum.stableNormalized();
}

/// NaN if a corner that counts has none.
double valueAt(const TriangleTree& tree, const VectorXd& values, const ClosestPlace& place) {
  double sum = 0;
  for (int k = 0; k < 3; ++k)
    if (place.barycentric[k] != 0) sum += place.barycentric[k] * values[tree.vertexOf(place.triangle, k)];
  return sum;
}

}  // namespace

SurfaceComparison::SurfaceComparison(const Surface& preop, const Surface& scan,
                                     const DistanceSettings& settings)
    : preop_(preop),
      scan_(scan),
      reach_(settings.reachMm),
      leastCosine_(std::cos(settings.normalLimitDeg * std::numbers::pi / 180)),
      preopNormals_(vertexNormals(preop)),
      scanNormals_(normalsOf(scan)),
      preopTree_(preop),
      preopBorder_(preop) {
  const auto segments = preop.arrays.find(kCouinaudSegment);
  if (segments != preop.arrays.end()) segments_ = &segments->second;
  if (scan.triangles.rows() > 0) {
    scanTree_.emplace(scan);
    scanBorder_.emplace(scan);
  } else {
    scanCloud_ = KdTree(scan.points);
    cloudBorder_.emplace(scanCloud_, scan.points);
  }
  if (settings.curvatureRadiusMm > 0) measureCurvature(settings.curvatureRadiusMm);
}

void SurfaceComparison::measureCurvature(double radiusMm) {
  CurvatureSettings fit;
  fit.radiusMm = radiusMm;
  fit.largestLean = 0.25;  // near its border a noisy scan errs two to three times as much as in its middle
  preopCurvature_ = meanCurvature(preop_, fit);
  if (scan_.triangles.rows() > 0 || scanNormals_.rows() > 0) {
    scanCurvature_ = meanCurvature(scan_, fit);
    return;
  }
  // A cloud without normals faces as the pre-op surface nearest to it does; the fit takes up the tilt.
  Surface facing;
  facing.points = scan_.points;
  facing.normals.resize(scan_.size(), 3);
  forEachChunk(static_cast<std::size_t>(scan_.size()), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      facing.normals.row(row) =
          normalAt(preopTree_, preopNormals_, preopTree_.closest(scan_.points.row(row).transpose()));
    }
  });
  scanCurvature_ = meanCurvature(facing, fit);
}

/// Zero normals are not known, and oppose nothing.
bool SurfaceComparison::opposed(const Vector3d& a, const Vector3d& b) const {
  return a.squaredNorm() > 0 && b.squaredNorm() > 0 && !(a.dot(b) > leastCosine_);
}

double SurfaceComparison::segmentAt(const ClosestPlace& place) const {
  if (segments_ == nullptr || place.triangle < 0) return 0;
  Index nearest = 0;  // corner
  place.barycentric.maxCoeff(&nearest);
  return (*segments_)[preopTree_.vertexOf(place.triangle, static_cast<int>(nearest))];
}

PlaceMeasured SurfaceComparison::atScanPoint(Index i) const {
  PlaceMeasured measured;
  const Vector3d point = scan_.points.row(i), normal = rowOf(scanNormals_, i);
  const ClosestPlace place = preopTree_.closest(point, reach_);
  if (place.triangle < 0) return measured;
  measured.segment = segmentAt(place);
  const Vector3d preopNormal = normalAt(preopTree_, preopNormals_, place);
  if (opposed(normal, preopNormal)) return measured;
  if (preopBorder_.holds(place.triangle, place.barycentric) &&
      leadsAside(point - place.point, normal, preopNormal))
    return measured;
  measured.distanceMm = place.side * place.distance;
  if (scanCurvature_.size() > 0)
    measured.curvatureDifferencePerMm = scanCurvature_[i] - valueAt(preopTree_, preopCurvature_, place);
  return measured;
}

PlaceMeasured SurfaceComparison::atPreopVertex(Index i) const {
  PlaceMeasured measured;
  // A point of no triangle has no outside.
  if (preopNormals_.row(i).squaredNorm() > 0) measured = scanTree_ ? toTriangles(i) : toPoints(i);
  if (segments_ != nullptr) measured.segment = (*segments_)[i];
  return measured;
}

PlaceMeasured SurfaceComparison::toTriangles(Index i) const {
  PlaceMeasured measured;
  const Vector3d vertex = preop_.points.row(i), normal = preopNormals_.row(i);
  const ClosestPlace place = scanTree_->closest(vertex, reach_);
  if (place.triangle < 0) return measured;
  const Vector3d scanNormal = normalAt(*scanTree_, scanNormals_, place), offset = place.point - vertex;
  if (opposed(normal, scanNormal)) return measured;
  if (scanBorder_->holds(place.triangle, place.barycentric) && leadsAside(offset, normal, scanNormal))
    return measured;
  measured.distanceMm = offset.dot(normal) < 0 ? -place.distance : place.distance;
  if (scanCurvature_.size() > 0)
    measured.curvatureDifferencePerMm = valueAt(*scanTree_, scanCurvature_, place) - preopCurvature_[i];
  return measured;
}

PlaceMeasured SurfaceComparison::toPoints(Index i) const {
  PlaceMeasured measured;
  const Vector3d vertex = preop_.points.row(i), normal = preopNormals_.row(i);
  // Most vertices have no scan near: one neighbour tells it sooner than six.
  const double bound = std::nextafter(reach_ * reach_, std::numeric_limits<double>::infinity());
  if (scanCloud_.nearest(vertex, bound).index < 0) return measured;
  const std::vector<Neighbour> nearest = scanCloud_.nearest(vertex, 6);
  const double distance = std::sqrt(nearest.front().squaredDistance);
  if (distance > reach_) return measured;
  const int first = nearest.front().index;
  const ClosestPlace back = preopTree_.closest(scan_.points.row(first).transpose(), distance);
  if (back.distance < 0.5 * distance && distance > 1.5 * cloudBorder_->spacingAt(first))
    return measured;  // the point belongs to another place of the surface, through a thin lobe or across a
                      // fold
  if (opposed(normal, cloudNormal(first, back))) return measured;
  if (cloudBorder_->isPassed(vertex, normal, first)) return measured;
  // Near contact the nearest point may lie a spacing aside, its height mere noise: the points around it
  // vote.
  double height = 0;
  for (const Neighbour& neighbour : nearest)
    height += (scan_.points.row(neighbour.index).transpose() - vertex).dot(normal);
  measured.distanceMm = height < 0 ? -distance : distance;
  if (scanCurvature_.size() > 0)
    measured.curvatureDifferencePerMm = scanCurvature_[first] - preopCurvature_[i];
  return measured;
}

/// A cloud without normals is taken to face as the pre-op surface nearest to it, at `back`, does: so that a
/// scan of one side of a thin lobe does not cover the other.
Vector3d SurfaceComparison::cloudNormal(int point, const ClosestPlace& back) const {
  if (scanNormals_.rows() > 0) return scanNormals_.row(point);
  return back.triangle < 0 ? Vector3d::Zero() : normalAt(preopTree_, preopNormals_, back);
}

}  // namespace falciform
