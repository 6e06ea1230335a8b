#include "Logic/Geometry/GridField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

constexpr double kMaxCorners = 2e7;

GridField latticeAround(const Surface& surface, double cellMm, double marginMm) {
  const auto box = boundingBox(surface.points);
  const Vector3d low = box.row(0).transpose().array() - marginMm,
                 size = (box.row(1) - box.row(0)).transpose().array() + 2 * marginMm + cellMm;
  GridField field;
  field.cellMm = std::max(cellMm, std::cbrt(size.prod() / kMaxCorners));
  field.counts = (size / field.cellMm).array().ceil().cast<int>() + 1;
  // Off any lattice that the points may come from, so that lines seldom meet their edges.
  field.origin = low.array() - field.cellMm * Vector3d(0.1234567, 0.2718281, 0.3141592).array();
  return field;
}

/// Where a line along x passes through the surface: +1 into it, -1 out of it.
struct Passage {
  double x;
  int turn;
};

/// Twice the signed area of p, a, b in the yz plane, computed the same (but for sign) from both ends, and p
/// moved aside by e and e^2 for a vanishing e where it lies on the edge: so that a line through an edge
/// passes exactly one of its two triangles, and one through a vertex none or one of its fan on each side.
double turnOf(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const bool swapped = std::pair(a.y(), a.z()) > std::pair(b.y(), b.z());
  const Vector3d &u = swapped ? b : a, &v = swapped ? a : b;
  using Long = long double;
  const auto area = static_cast<double>((Long(u.y()) - p.y()) * (Long(v.z()) - p.z()) -
                                        (Long(u.z()) - p.z()) * (Long(v.y()) - p.y()));
  const double aside = u.z() != v.z() ? u.z() - v.z() : v.y() - u.y();
  const double decided = area != 0 ? area : std::copysign(std::numeric_limits<double>::min(), aside);
  return swapped ? -decided : decided;
}

std::vector<std::vector<Passage>> passagesOf(const Surface& surface, const GridField& field) {
  std::vector<std::vector<Passage>> lines(static_cast<std::size_t>(field.counts.y()) *
                                          static_cast<std::size_t>(field.counts.z()));
  const auto corner = [&](double at, int axis) { return (at - field.origin[axis]) / field.cellMm; };
  const auto first = [&](double at, int axis) {
    return std::max(static_cast<int>(std::ceil(corner(at, axis))), 0);
  };
  const auto last = [&](double at, int axis) {
    return std::min(static_cast<int>(std::floor(corner(at, axis))), field.counts[axis] - 1);
  };
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    std::array<Vector3d, 3> c;
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = surface.points.row(surface.triangles(t, static_cast<Index>(k))).transpose();
    const Vector3d low = c[0].cwiseMin(c[1]).cwiseMin(c[2]), high = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
    for (int z = first(low.z(), 2); z <= last(high.z(), 2); ++z)
      for (int y = first(low.y(), 1); y <= last(high.y(), 1); ++y) {
        const Vector3d p = field.place(0, y, z);
        const double ab = turnOf(p, c[0], c[1]), bc = turnOf(p, c[1], c[2]), ca = turnOf(p, c[2], c[0]);
        if (!((ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0))) continue;
        const double x = (bc * c[0].x() + ca * c[1].x() + ab * c[2].x()) / (ab + bc + ca);
        lines[static_cast<std::size_t>(y + field.counts.y() * z)].push_back({x, ab > 0 ? -1 : 1});
      }
  }
  return lines;
}

}  // namespace

GridField signedDistanceField(const Surface& surface, double cellMm, double bandMm) {
  return signedDistanceField(surface, TriangleTree(surface), cellMm, bandMm);
}

GridField signedDistanceField(const Surface& surface, const TriangleTree& tree, double cellMm,
                              double bandMm) {
  GridField field = latticeAround(surface, cellMm, bandMm + 2 * cellMm);
  std::vector<std::vector<Passage>> lines = passagesOf(surface, field);
  field.values.resize(lines.size() * static_cast<std::size_t>(field.counts.x()));
  forEachChunk(lines.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line) {
      std::vector<Passage>& passages = lines[line];
      std::sort(passages.begin(), passages.end(),
                [](const Passage& a, const Passage& b) { return a.x < b.x; });
      const int y = static_cast<int>(line) % field.counts.y(), z = static_cast<int>(line) / field.counts.y();
      int winding = 0;
      std::size_t next = 0;
      double before = bandMm;
      for (int x = 0; x < field.counts.x(); ++x) {
        const Vector3d place = field.place(x, y, z);
        for (; next < passages.size() && passages[next].x < place.x(); ++next) winding += passages[next].turn;
        // Within a cell of the last: the search is short although the surface may be far.
        const double bound = std::min(bandMm, (before + field.cellMm) * (1 + 1e-9));
        const double distance = std::min(bandMm, tree.closest(place, bound).distance);
        before = distance;
        field.values[field.index(x, y, z)] = static_cast<float>(winding > 0 ? -distance : distance);
      }
    }
  });
  return field;
}

Surface roundedSurface(const Surface& surface, double closeMm, double openMm, double cellMm) {
  const auto moved = [&](const Surface& from, double level) {
    return levelSurface(signedDistanceField(from, cellMm, std::abs(level) + 2 * cellMm), level);
  };
  if (closeMm <= 0 && openMm <= 0) return largestPiece(moved(surface, 0));
  Surface result = closeMm > 0 ? moved(surface, closeMm) : surface;
  result = largestPiece(moved(largestPiece(result), -(closeMm + openMm)));
  return openMm > 0 ? largestPiece(moved(result, openMm)) : result;
}

}  // namespace falciform
