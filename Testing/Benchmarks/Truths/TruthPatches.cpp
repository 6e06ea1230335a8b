#include "Testing/Benchmarks/Truths/TruthPatches.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"

namespace falciform::bench {
namespace {

constexpr double kHalfStripMm = 4;      // of the groove
constexpr double kNeighbourhoodMm = 8;  // about the margin's radius of curvature
constexpr double kMarginHalfMm = 3;     // of the painted margin
constexpr double kSliceMm = 2;          // of the slices in which it is sought
constexpr double kLeastGrooveMm2 = 90, kLeastMarginMm2 = 360;

/// The segment of the labelled voxel nearest to a place, within `reach` voxels; 0 if there is none.
int segmentAt(const LabelMap& map, const Matrix4d& indexFromWorld, const Vector3d& place, int reach) {
  const Vector3d index = (indexFromWorld * place.homogeneous()).head<3>();
  const Vector3i middle = index.array().round().cast<int>();
  const Vector3d spacing = map.spacing();
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int dk = -reach; dk <= reach; ++dk)
    for (int dj = -reach; dj <= reach; ++dj)
      for (int di = -reach; di <= reach; ++di) {
        const Vector3i at = middle + Vector3i(di, dj, dk);
        if ((at.array() < 0).any() || (at.array() >= map.size.array()).any()) continue;
        const int label = map.at(at.x(), at.y(), at.z());
        const double d = (at.cast<double>() - index).cwiseProduct(spacing).squaredNorm();
        if (label > 0 && d < least) least = d, best = label;
      }
  return best;
}

/// Of a set of vertices the pieces that hang together and have at least `share` of the largest one's size.
std::vector<int> largePieces(const Surface& surface, const std::vector<int>& ids, double share) {
  const Adjacency next = neighboursOfVertices(surface.triangles, surface.size());
  std::vector<char> in(static_cast<std::size_t>(surface.size()), 0);
  for (const int v : ids) in[static_cast<std::size_t>(v)] = 1;
  std::vector<std::vector<int>> pieces;
  for (const int first : ids) {
    if (!in[static_cast<std::size_t>(first)]) continue;
    std::vector<int> piece{first};
    in[static_cast<std::size_t>(first)] = 0;
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (const int* v = next.begin(piece[n]); v != next.end(piece[n]); ++v)
        if (in[static_cast<std::size_t>(*v)]) in[static_cast<std::size_t>(*v)] = 0, piece.push_back(*v);
    pieces.push_back(std::move(piece));
  }
  std::size_t largest = 0;
  for (const auto& piece : pieces) largest = std::max(largest, piece.size());
  std::vector<int> kept;
  for (const auto& piece : pieces)
    if (static_cast<double>(piece.size()) >= share * static_cast<double>(largest))
      kept.insert(kept.end(), piece.begin(), piece.end());
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::vector<int> groove(const Surface& liver, const Points& normals, const LabelMap& map) {
  const std::vector<int> segments = segmentsAtSurface(liver, map);
  std::vector<int> medial, lateral;
  for (Index v = 0; v < liver.size(); ++v) {
    const int segment = segments[static_cast<std::size_t>(v)];
    if (segment == 4) medial.push_back(static_cast<int>(v));
    if (segment == 2 || segment == 3) lateral.push_back(static_cast<int>(v));
  }
  if (medial.empty() || lateral.empty())
    throw InputError("the segments' map has no border of segment 4 with 2 and 3 at the surface");
  const KdTree medialTree(liver.points, medial), lateralTree(liver.points, lateral);
  std::vector<int> strip;
  const auto collect = [&](const std::vector<int>& side, const KdTree& other) {
    for (const int v : side)
      if (normals(v, 1) < -0.4 &&
          other.nearest(liver.points.row(v).transpose()).squaredDistance < kHalfStripMm * kHalfStripMm)
        strip.push_back(v);
  };
  collect(medial, lateralTree);
  collect(lateral, medialTree);
  std::sort(strip.begin(), strip.end());
  return largePieces(liver, strip, 0.3);
}

/// How sharply the surface bends outwards about a vertex: 0 flat, or a hollow, towards 1 at a knife's edge.
double sharpness(const Surface& liver, const Points& normals, const KdTree& tree, int v) {
  const Vector3d place = liver.points.row(v).transpose();
  const std::vector<int> near = tree.within(place, kNeighbourhoodMm);
  const Vector3d normal = normals(near, Eigen::all).colwise().mean().transpose(),
                 centre = liver.points(near, Eigen::all).colwise().mean().transpose();
  // The centre of the neighbourhood lies behind a margin, and in front of a hollow.
  return (place - centre).dot(normal) > 0 ? 1 - normal.norm() : 0;
}

/// In every sagittal slice the place that reaches farthest down and to the front, where the liver is sharp.
std::vector<int> inferiorMargin(const Surface& liver, const Points& normals) {
  const auto box = boundingBox(liver.points);
  const auto columns = static_cast<int>((box(1, 0) - box(0, 0)) / kSliceMm) + 1;
  const Vector3d reach = Vector3d(0, -0.6, -0.8);
  std::vector<int> farthest(static_cast<std::size_t>(columns), -1);
  for (Index v = 0; v < liver.size(); ++v) {
    int& best = farthest[static_cast<std::size_t>((liver.points(v, 0) - box(0, 0)) / kSliceMm)];
    if (best < 0 || (liver.points.row(v) - liver.points.row(best)).dot(reach) > 0) best = static_cast<int>(v);
  }
  const KdTree tree(liver.points);
  std::vector<int> line;
  for (const int v : farthest)
    if (v >= 0 && sharpness(liver, normals, tree, v) > 0.12) line.push_back(v);
  if (line.empty()) throw InputError("the surface has no sharp inferior margin");
  const KdTree lineTree(liver.points, line);
  std::vector<int> strip;
  for (Index v = 0; v < liver.size(); ++v)
    if (lineTree.nearest(liver.points.row(v).transpose()).squaredDistance < kMarginHalfMm * kMarginHalfMm)
      strip.push_back(static_cast<int>(v));
  return largePieces(liver, strip, 0.15);
}

}  // namespace

std::vector<int> segmentsAtSurface(const Surface& liver, const LabelMap& segments) {
  const Points normals = vertexNormals(liver);
  const Matrix4d indexFromWorld = segments.worldFromIndex.inverse();
  std::vector<int> found;
  for (Index v = 0; v < liver.size(); ++v)
    found.push_back(
        segmentAt(segments, indexFromWorld, (liver.points.row(v) - 2 * normals.row(v)).transpose(), 3));
  return found;
}

std::vector<int> paintedBySegments(const Surface& liver, const LabelMap& segments) {
  const Points normals = vertexNormals(liver);
  std::vector<int> labels(static_cast<std::size_t>(liver.size()), patch::kNone);
  const std::vector<int> margin = inferiorMargin(liver, normals), strip = groove(liver, normals, segments);
  for (const int v : margin) labels[static_cast<std::size_t>(v)] = patch::kInferiorRidge;
  for (const int v : strip) labels[static_cast<std::size_t>(v)] = patch::kFalciform;
  const VectorXd areas = vertexAreas(liver);
  const double stripMm2 = areas(strip).sum(), marginMm2 = areas(margin).sum();
  if (stripMm2 < kLeastGrooveMm2 || marginMm2 < kLeastMarginMm2)
    throw InputError("groove and margin are of " + std::to_string(stripMm2) + " and " +
                     std::to_string(marginMm2) + " mm2: too small to register with");
  return labels;
}

}  // namespace falciform::bench
