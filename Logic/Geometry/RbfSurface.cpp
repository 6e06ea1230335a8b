#include "Logic/Geometry/RbfSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/FanSplitting.h"
#include "Logic/Geometry/GridField.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/PointSpacing.h"
#include "Logic/Geometry/Remesh.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

constexpr double kNormalReach = 3;  ///< spacings: given normals are averaged over so far
constexpr double kCovered = 2;      ///< spacings: the surface is known so far from a point
constexpr double kEdgePerSpacing =
    1.075;  ///< of equilateral triangles with one vertex a square of the spacing
constexpr int kPasses = 4;
constexpr std::size_t kChunk = 512;
constexpr double kMaxCorners = 6e7;

/// Normals of the points, averaged with those near that face the same way: which side is outside is all that
/// they must tell.
Points outwards(const Surface& surface, const KdTree& tree, double reachMm) {
  if (surface.triangles.rows() == 0 && surface.normals.rows() == 0)
    throw InputError(
        "the points have neither triangles nor normals, so they have no outside; compute normals first");
  const Points given = surface.triangles.rows() > 0 ? vertexNormals(surface) : surface.normals;
  Points result(given.rows(), 3);
  forEachChunk(static_cast<std::size_t>(given.rows()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      Vector3d sum = Vector3d::Zero();
      for (const int j : tree.within(surface.points.row(i), reachMm))
        if (given.row(i).dot(given.row(j)) > 0) sum += given.row(j).transpose();
      result.row(i) = sum.stableNormalized().transpose();
    }
  });
  return result;
}

/// The function's values at the corners of a lattice no farther than `reachMm` from a point, NaN elsewhere.
GridField fieldNear(const RbfFunction& function, const Points& points, double cellMm, double reachMm) {
  GridField field;
  const auto box = boundingBox(points);
  const Vector3d low = box.row(0).transpose().array() - reachMm - 2 * cellMm,
                 size = (box.row(1) - box.row(0)).transpose().array() + 2 * reachMm + 4 * cellMm;
  field.cellMm = std::max(cellMm, std::cbrt(size.prod() / kMaxCorners));
  field.counts = (size / field.cellMm).array().ceil().cast<int>() + 1;
  field.origin = low;
  field.values.assign(static_cast<std::size_t>(field.counts.x()) *
                          static_cast<std::size_t>(field.counts.y()) *
                          static_cast<std::size_t>(field.counts.z()),
                      std::numeric_limits<float>::quiet_NaN());
  std::vector<char> near(field.values.size(), 0);
  const int steps = static_cast<int>(std::ceil(reachMm / field.cellMm));
  std::vector<Vector3i> ball;
  for (int z = -steps; z <= steps + 1; ++z)
    for (int y = -steps; y <= steps + 1; ++y)
      for (int x = -steps; x <= steps + 1; ++x)
        if ((Vector3d(x, y, z).array() - 0.5).matrix().norm() * field.cellMm <= reachMm + 0.87 * field.cellMm)
          ball.emplace_back(x, y, z);
  std::vector<char> done(field.values.size(), 0);  // one ball a cell, from its middle
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3i cell =
        ((points.row(i).transpose() - field.origin) / field.cellMm).array().floor().cast<int>();
    char& seen = done[field.index(cell.x(), cell.y(), cell.z())];
    if (seen != 0) continue;
    seen = 1;
    for (const Vector3i& step : ball) {
      const Vector3i c = (cell + step).cwiseMax(0).cwiseMin(field.counts - Vector3i::Ones());
      near[field.index(c.x(), c.y(), c.z())] = 1;
    }
  }
  std::vector<std::size_t> corners;
  for (std::size_t c = 0; c < near.size(); ++c)
    if (near[c] != 0) corners.push_back(c);
  const auto nx = static_cast<std::size_t>(field.counts.x()), ny = static_cast<std::size_t>(field.counts.y());
  forEachChunk(corners.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t c = corners[k];
      field.values[c] = static_cast<float>(function.value(field.place(
          static_cast<int>(c % nx), static_cast<int>(c / nx % ny), static_cast<int>(c / (nx * ny)))));
    }
  });
  return field;
}

/// Per vertex its distance to the nearest point, mm, and which that is.
std::vector<Neighbour> nearestPoints(const Surface& surface, const KdTree& tree) {
  std::vector<Neighbour> nearest(static_cast<std::size_t>(surface.size()));
  forEachChunk(nearest.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      nearest[i] = tree.nearest(Vector3d(surface.points.row(static_cast<Index>(i))));
  });
  return nearest;
}

/// Pieces of vertices for which `in` holds, joined by edges: their number a vertex, -1 outside.
std::vector<int> piecesOf(const Adjacency& ring, const std::vector<char>& in, int& count) {
  std::vector<int> piece(in.size(), -1), stack;
  count = 0;
  for (std::size_t seed = 0; seed < in.size(); ++seed) {
    if (in[seed] == 0 || piece[seed] >= 0) continue;
    piece[seed] = count;
    stack.push_back(static_cast<int>(seed));
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      for (const int* n = ring.begin(v); n != ring.end(v); ++n)
        if (const auto at = static_cast<std::size_t>(*n); in[at] != 0 && piece[at] < 0) {
          piece[at] = count;
          stack.push_back(*n);
        }
    }
    ++count;
  }
  return piece;
}

std::vector<char> borderVertices(const Surface& surface) {
  // Closed around a vertex: as many neighbours as triangles.
  const Adjacency faces = trianglesOfVertices(surface.triangles, surface.size()),
                  ring = neighboursOfVertices(surface.triangles, surface.size());
  std::vector<char> border(static_cast<std::size_t>(surface.size()));
  for (int v = 0; v < static_cast<int>(surface.size()); ++v)
    border[static_cast<std::size_t>(v)] = ring.count(v) != faces.count(v);
  return border;
}

/// Vertices to keep: those near points, and those between that bridge a gap up to `gapMm` wide without
/// reaching the border. Pieces of the surface that lie mostly away from the points are none of theirs.
std::vector<int> supported(const Surface& surface, const std::vector<Neighbour>& nearest, double coveredMm,
                           double gapMm, Index& filled) {
  const Adjacency ring = neighboursOfVertices(surface.triangles, surface.size());
  const std::vector<char> border = borderVertices(surface);
  const auto n = static_cast<std::size_t>(surface.size());
  std::vector<char> all(n, 1), away(n, 0);
  for (std::size_t v = 0; v < n; ++v) away[v] = nearest[v].squaredDistance > coveredMm * coveredMm;
  int sheets = 0, gaps = 0;
  const std::vector<int> sheet = piecesOf(ring, all, sheets), gap = piecesOf(ring, away, gaps);
  std::vector<Index> size(static_cast<std::size_t>(sheets), 0), near = size;
  std::vector<char> open(static_cast<std::size_t>(gaps), 0);
  for (std::size_t v = 0; v < n; ++v) {
    ++size[static_cast<std::size_t>(sheet[v])];
    near[static_cast<std::size_t>(sheet[v])] += away[v] == 0;
    if (gap[v] < 0) continue;
    if (border[v] != 0 || nearest[v].squaredDistance > gapMm * gapMm / 4)
      open[static_cast<std::size_t>(gap[v])] = 1;
  }
  std::vector<int> keep;
  filled = 0;
  for (std::size_t v = 0; v < n; ++v) {
    const auto s = static_cast<std::size_t>(sheet[v]);
    if (2 * near[s] < size[s]) continue;
    if (away[v] != 0 && open[static_cast<std::size_t>(gap[v])] != 0) continue;
    filled += away[v] != 0;
    keep.push_back(static_cast<int>(v));
  }
  return keep;
}

void settle(Surface& surface, const RbfFunction& function, double reachMm) {
  forEachChunk(static_cast<std::size_t>(surface.size()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
      surface.points.row(i) = function.ontoZero(surface.points.row(i), reachMm).transpose();
  });
}

/// What the function says of each vertex, and what was painted on the nearest point.
void describeVertices(Surface& surface, const Surface& before, const RbfFunction& function,
                      const KdTree& tree) {
  surface.normals.resize(surface.size(), 3);
  VectorXd curvature(surface.size());
  forEachChunk(static_cast<std::size_t>(surface.size()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      const Jet jet = function.jet(surface.points.row(i));
      surface.normals.row(i) = normalOf(jet).transpose();
      curvature[i] = meanCurvatureOf(jet);
    }
  });
  const std::vector<Neighbour> nearest = nearestPoints(surface, tree);
  std::vector<int> ids;
  for (const Neighbour& n : nearest) ids.push_back(n.index);
  if (!before.patch.empty())
    for (const int id : ids) surface.patch.push_back(before.patchAt(id));
  if (before.colours.rows() > 0) surface.colours = before.colours(ids, Eigen::all);
  if (before.textureAt.rows() > 0) surface.textureAt = before.textureAt(ids, Eigen::all);
  surface.texture = before.texture;
  for (const auto& [name, values] : before.arrays) surface.arrays[name] = values(ids);
  surface.patchNames = before.patchNames;
  surface.frame = before.frame;
  surface.arrays[kMeanCurvature] = std::move(curvature);
}

/// Before the grid, which would be as fine, is made.
void checkEdge(double edgeMm, double spacingMm, Index points) {
  constexpr double kMostTriangles = 2e7;
  const double area = static_cast<double>(points) * spacingMm * spacingMm,
               least = std::sqrt(area / kMostTriangles * 4 / std::sqrt(3.0));
  if (edgeMm >= least) return;
  std::ostringstream text;
  text << "an edge length of " << edgeMm << " mm would make more than 20 million triangles; choose at least "
       << least << " mm";
  throw InputError(text.str());
}

}  // namespace

RbfSurfaceResult smoothByRbf(const Surface& surface, const RbfSurfaceSettings& settings,
                             const Progress& progress) {
  checkSettings(settings);
  checkSurface(surface, "the surface");
  if (surface.size() < 30)
    throw InputError("the surface has " + std::to_string(surface.size()) + " points; at least 30 are needed");
  RbfSurfaceResult result;
  progress.report(0, "Normals of the points");
  const KdTree tree(surface.points);
  const double spacing = pointSpacing(surface.points, tree);
  const Points normals = outwards(surface, tree, kNormalReach * spacing);
  result.edgeLengthMm = settings.edgeLengthMm > 0 ? settings.edgeLengthMm : kEdgePerSpacing * spacing;
  checkEdge(result.edgeLengthMm, spacing, surface.size());
  result.fit =
      fitRbf(surface.points, normals, {settings.noiseMm, settings.detailMm}, progress.part(0.03, 0.45));
  result.rmsMm = std::sqrt(result.fit.residual.squaredNorm() / static_cast<double>(surface.size()));
  result.largestMm = result.fit.residual.cwiseAbs().maxCoeff();
  for (const RbfLevelReport& level : result.fit.levels)
    if (!level.converged) {
      std::ostringstream text;
      text << "the functions " << level.stepMm << " mm apart were not solved for exactly";
      result.warnings.push_back(text.str());
    }

  progress.report(0.45, "Following the surface");
  const double covered = std::max(kCovered * spacing, 0.75 * result.edgeLengthMm);
  const double cell = std::min(result.edgeLengthMm, 2 * result.fit.levels.back().stepMm);
  Surface mesh = levelSurface(
      fieldNear(result.fit.function, surface.points, cell, covered + settings.fillHolesMm / 2), 0);
  if (mesh.triangles.rows() == 0)
    throw InputError("no surface passes through the points; check that their normals face one side");
  mesh = remeshIsotropic(withFansApart(mesh), result.edgeLengthMm, kPasses, progress.part(0.55, 0.9));
  progress.report(0.9, "Smooth surface");
  settle(mesh, result.fit.function, result.edgeLengthMm / 2);
  Index filled = 0;
  const std::vector<int> keep =
      supported(mesh, nearestPoints(mesh, tree), covered, settings.fillHolesMm, filled);
  if (keep.empty())
    throw InputError("no surface passes through the points; check that their normals face one side");
  result.surface = keep.size() < static_cast<std::size_t>(mesh.size()) ? subset(mesh, keep) : std::move(mesh);
  result.filledPoints = filled;
  describeVertices(result.surface, surface, result.fit.function, tree);
  progress.report(1, "Smooth surface");
  return result;
}

}  // namespace falciform
