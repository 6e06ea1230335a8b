#include "Logic/Biomechanics/MeshTumours.h"

#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/CrossingRepair.h"
#include "Logic/Biomechanics/MeshInput.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Crossings.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

constexpr double kClearance = 0.3;   ///< between surfaces, in edge lengths of the finer one
constexpr double kEdgesAcross = 4;   ///< of a tumour, at least
constexpr double kShortestEdge = 1;  ///< mm
constexpr double kMaxExtra = 20000;  ///< refining points

double diameterOfVolume(double mm3) { return 2 * std::cbrt(3 * mm3 / (4 * EIGEN_PI)); }

Points verticesAndMiddles(const Surface& surface) {
  Points all(surface.size() + surface.triangles.rows(), 3);
  all.topRows(surface.size()) = surface.points;
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    all.row(surface.size() + t) =
        surface.points(surface.triangles.row(t).transpose().eval(), Eigen::all).colwise().mean();
  return all;
}

/// Whether the surfaces are at least `gap` apart, as far as vertices and middles of triangles tell.
bool clearOf(const Surface& one, const Surface& other, double gap) {
  if (!crossings(one, other).empty()) return false;
  const auto far = [&](const Surface& from, const TriangleTree& to) {
    const Points places = verticesAndMiddles(from);
    for (Index i = 0; i < places.rows(); ++i)
      if (to.closest(places.row(i).transpose(), gap).triangle >= 0) return false;
    return true;
  };
  return far(one, TriangleTree(other)) && far(other, TriangleTree(one));
}

enum class Where { Inside, Across, Outside };
Where placeIn(const TriangleTree& liver, const Surface& piece) {
  bool in = false, out = false;
  for (Index i = 0; i < piece.size(); ++i)
    (liver.closest(piece.points.row(i).transpose()).side < 0 ? in : out) = true;
  return in && out ? Where::Across : in ? Where::Inside : Where::Outside;
}

/// Remeshed, and blown up by the little that the chords of its edges took away.
bool remeshPiece(TumourPiece& piece) {
  MeshableSurface remeshed = meshableSurface(piece.surface, piece.edgeMm, piece.edgeMm / 2);
  const double volume = signedVolume(remeshed.surface);
  if (!remeshed.left.empty() || !(volume > 0)) return false;
  const double scale = std::cbrt(signedVolume(piece.surface) / volume);
  if (!(scale < 1.3)) return false;  // too few triangles for its shape
  const Eigen::RowVector3d centre = centroid(remeshed.surface.points).transpose();
  Points& points = remeshed.surface.points;
  points = ((points.rowwise() - centre) * scale).rowwise() + centre;
  piece.surface = std::move(remeshed.surface);
  return true;
}

/// Why the piece cannot have faces of its own; empty if it can and now has them.
std::string conformed(TumourPiece& piece, const Surface& liver, const std::vector<TumourPiece>& others) {
  TumourPiece trial = piece;
  if (!remeshPiece(trial)) return "its surface cannot be remeshed";
  if (!clearOf(trial.surface, liver, kClearance * trial.edgeMm) ||
      placeIn(TriangleTree(liver), trial.surface) != Where::Inside)
    return "it reaches the liver's surface";
  for (const TumourPiece& other : others)
    if (other.conforming &&
        !clearOf(trial.surface, other.surface, kClearance * std::min(trial.edgeMm, other.edgeMm)))
      return other.region == piece.region ? "two of its pieces touch"
                                          : "it touches tumour " + std::to_string(other.region);
  piece = std::move(trial);
  return "";
}

}  // namespace

std::vector<TumourPiece> tumourPieces(const std::vector<Surface>& tumours, const Surface& liver,
                                      const MeshSettings& settings, std::vector<std::string>& warnings) {
  const TriangleTree tree(liver);
  std::vector<TumourPiece> pieces;
  for (std::size_t k = 0; k < tumours.size(); ++k) {
    const std::string what = "tumour " + std::to_string(k + 1);
    Index outside = 0;
    const std::vector<Surface> parts = piecesOf(closedSurface(tumours[k], what, Pieces::KeepAll, warnings));
    for (const Surface& part : parts) {
      if (placeIn(tree, part) == Where::Outside && crossings(part, liver).empty()) {
        ++outside;
        continue;
      }
      const double across = diameterOfVolume(std::abs(signedVolume(part)));
      TumourPiece piece{.region = static_cast<int>(k) + 1, .surface = part};
      piece.edgeMm = settings.tumourEdgeLengthMm > 0
                         ? settings.tumourEdgeLengthMm
                         : std::clamp(across / kEdgesAcross, kShortestEdge, settings.edgeLengthMm);
      if (signedVolume(part) > 0) {
        const std::string why = conformed(piece, liver, pieces);
        piece.conforming = why.empty();
        if (!why.empty())
          warnings.push_back(
              what + (parts.size() > 1 ? " has a piece without a surface" : " has no surface") +
              " of its own in the mesh: " + why + "; it is the elements whose centre is inside it");
      } else {
        warnings.push_back(what + ": a hollow inside it was filled");
        continue;
      }
      pieces.push_back(std::move(piece));
    }
    if (outside == std::ssize(parts))
      throw InputError(what + " lies outside the liver; check that both are in the same frame and in mm");
    if (outside > 0)
      warnings.push_back(what + ": " + std::to_string(outside) + " of its " + std::to_string(parts.size()) +
                         " pieces lie outside the liver and were left out");
  }
  return pieces;
}

Points refiningPoints(const std::vector<TumourPiece>& pieces, const Surface& liver) {
  std::vector<Vector3d> places;
  std::vector<TriangleTree> trees{TriangleTree(liver)};
  for (const TumourPiece& piece : pieces)
    if (piece.conforming) trees.emplace_back(piece.surface);
  for (const TumourPiece& piece : pieces) {
    if (piece.conforming) continue;
    const TriangleTree inside(piece.surface);
    const auto box = boundingBox(piece.surface.points);
    const Vector3d low = box.row(0).transpose(), size = (box.row(1) - box.row(0)).transpose();
    // A body-centred lattice: its tetrahedra are well shaped.
    const double step = std::max(1.07 * piece.edgeMm, std::cbrt(2 * size.prod() / kMaxExtra));
    const double gap = step / 2;
    const auto consider = [&](const Vector3d& place) {
      if (inside.closest(place).side > 0 || trees.front().closest(place).side > 0) return;
      for (const TriangleTree& tree : trees)
        if (tree.closest(place, gap).triangle >= 0) return;
      for (const Vector3d& other : places)
        if ((other - place).squaredNorm() < gap * gap) return;  // of another piece
      places.push_back(place);
    };
    for (double z = low.z(); z <= low.z() + size.z(); z += step)
      for (double y = low.y(); y <= low.y() + size.y(); y += step)
        for (double x = low.x(); x <= low.x() + size.x(); x += step) {
          consider({x, y, z});
          consider(Vector3d(x, y, z).array() + step / 2);
        }
  }
  Points points(std::ssize(places), 3);
  for (Index i = 0; i < points.rows(); ++i) points.row(i) = places[static_cast<std::size_t>(i)].transpose();
  return points;
}

std::vector<int> regionsOf(const TetrahedralMesh& mesh, const std::vector<TumourPiece>& pieces) {
  std::vector<TriangleTree> trees;
  std::vector<double> volumes;
  for (const TumourPiece& piece : pieces) {
    trees.emplace_back(piece.surface);
    volumes.push_back(signedVolume(piece.surface));
  }
  std::vector<int> regions(static_cast<std::size_t>(mesh.size()), 0);
  forEachChunk(regions.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto corners = mesh.elements.row(static_cast<Index>(e)).head(4).transpose().eval();
      const Vector3d centre = mesh.points(corners, Eigen::all).colwise().mean().transpose();
      double smallest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (volumes[k] >= smallest || trees[k].closest(centre).side > 0) continue;
        smallest = volumes[k];
        regions[e] = pieces[k].region;
      }
    }
  });
  return regions;
}

}  // namespace falciform
