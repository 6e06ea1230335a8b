#include "Logic/Patches/ColourPatch.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

constexpr double kLeastSpread = 4;  ///< of 255: a camera's own noise, so that no colour is too sure
constexpr double kEdgeLevels = 20;  ///< of 255: colours so far apart hold together by 1/e
constexpr int kCloudNeighbours = 8;
constexpr int kFewest = 10;  ///< vertices on a side, for its colour to be known

/// Colours of one side: mean and inverse covariance.
struct ColourModel {
  Vector3d mean = Vector3d::Zero();
  Matrix3d precision = Matrix3d::Identity();
  double logDeterminant = 0;  ///< of the covariance
  [[nodiscard]] double logDensity(const Vector3d& colour) const {
    const Vector3d off = colour - mean;
    return -0.5 * (off.dot(precision * off) + logDeterminant);
  }
};

ColourModel modelOf(const std::vector<Vector3d>& colours) {
  ColourModel model;
  for (const Vector3d& c : colours) model.mean += c / static_cast<double>(colours.size());
  Matrix3d covariance = kLeastSpread * kLeastSpread * Matrix3d::Identity();
  for (const Vector3d& c : colours)
    covariance += (c - model.mean) * (c - model.mean).transpose() / static_cast<double>(colours.size());
  model.precision = covariance.inverse();
  model.logDeterminant = std::log(covariance.determinant());
  return model;
}

/// The vertices that may change, those around them that may not, and who is whose neighbour.
struct Region {
  std::vector<int> vertices;  ///< of the surface, ascending
  std::vector<Vector3d> colours;
  std::vector<std::vector<int>> neighbours;  ///< places in `vertices`
  std::vector<char> rough;
};

Region regionAround(const Surface& surface, const std::vector<int>& rough, double reachMm) {
  const KdTree tree(surface.points, rough);
  Region region;
  std::vector<int> place(static_cast<std::size_t>(surface.size()), -1);
  for (Index i = 0; i < surface.size(); ++i) {
    if (tree.nearest(surface.points.row(i), reachMm * reachMm).index < 0) continue;
    place[static_cast<std::size_t>(i)] = static_cast<int>(region.vertices.size());
    region.vertices.push_back(static_cast<int>(i));
    region.colours.emplace_back(surface.colours.row(i).cast<double>().transpose());
    region.rough.push_back(std::binary_search(rough.begin(), rough.end(), static_cast<int>(i)) ? 1 : 0);
  }
  region.neighbours.resize(region.vertices.size());
  const bool mesh = surface.triangles.rows() > 0;
  const Adjacency edges = mesh ? neighboursOfVertices(surface.triangles, surface.size()) : Adjacency{};
  const KdTree all = mesh ? KdTree() : KdTree(surface.points, region.vertices);
  const auto join = [&](std::size_t a, int vertex) {
    const int b = place[static_cast<std::size_t>(vertex)];
    if (b < 0 || b == static_cast<int>(a)) return;
    region.neighbours[a].push_back(b);
    if (!mesh) region.neighbours[static_cast<std::size_t>(b)].push_back(static_cast<int>(a));
  };
  for (std::size_t a = 0; a < region.vertices.size(); ++a) {
    const int v = region.vertices[a];
    if (mesh)
      for (const int* n = edges.begin(v); n != edges.end(v); ++n) join(a, *n);
    else
      for (const Neighbour& n : all.nearest(surface.points.row(v), kCloudNeighbours + 1)) join(a, n.index);
  }
  for (std::vector<int>& list : region.neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return region;
}

/// Grady's random walker with priors: x minimises s sum w_ij (x_i - x_j)^2 + sum |odds_i| (x_i - [odds_i >
/// 0])^2.
VectorXd walked(const Region& region, const VectorXd& odds, double smoothness) {
  const auto n = static_cast<Index>(region.vertices.size());
  std::vector<Eigen::Triplet<double>> entries;
  VectorXd right = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    const auto a = static_cast<std::size_t>(i);
    double diagonal = std::abs(odds[i]) + 1e-6;
    if (odds[i] > 0) right[i] = odds[i];
    for (const int b : region.neighbours[a]) {
      const double apart =
          (region.colours[a] - region.colours[static_cast<std::size_t>(b)]).norm() / kEdgeLevels;
      const double w = smoothness * std::exp(-apart * apart);
      diagonal += w;
      entries.emplace_back(i, b, -w);
    }
    entries.emplace_back(i, i, diagonal);
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
}

/// Without the pieces that do not touch the rough patch.
void keepTouching(const Region& region, std::vector<char>& inside) {
  std::vector<char> kept(inside.size(), 0);
  std::vector<int> front;
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (inside[i] && region.rough[i]) kept[i] = 1, front.push_back(static_cast<int>(i));
  while (!front.empty()) {
    const auto at = static_cast<std::size_t>(front.back());
    front.pop_back();
    for (const int b : region.neighbours[at]) {
      const auto next = static_cast<std::size_t>(b);
      if (inside[next] && !kept[next]) kept[next] = 1, front.push_back(b);
    }
  }
  inside = std::move(kept);
}

double contrastBetween(const ColourModel& a, const ColourModel& b) {
  const Matrix3d pooled = 0.5 * (a.precision.inverse() + b.precision.inverse());
  const Vector3d off = a.mean - b.mean;
  return std::sqrt(off.dot(pooled.inverse() * off));
}

}  // namespace

ColourPatch refinePatchByColour(const Surface& surface, int label, const ColourPatchSettings& settings) {
  checkSettings(settings);
  if (surface.colours.rows() != surface.size())
    throw InputError("the surface has no colours; a patch can be refined by colour on a textured scan only");
  const std::vector<int> rough = pointsOfPatch(surface, label);
  if (rough.empty())
    throw InputError("patch '" + patchName(surface, label) + "' is painted nowhere; paint it roughly first");
  const Region region = regionAround(surface, rough, settings.reachMm);
  ColourPatch result;
  result.vertices = rough;
  std::vector<char> inside = region.rough;
  for (result.rounds = 0; result.rounds < settings.rounds;) {
    std::vector<Vector3d> in, out;
    for (std::size_t i = 0; i < inside.size(); ++i) (inside[i] ? in : out).push_back(region.colours[i]);
    if (static_cast<int>(std::min(in.size(), out.size())) < kFewest) {
      result.warnings.emplace_back(
          "the patch or what is around it has too few points for its colour to be known; it is "
          "left as it was");
      return result;
    }
    const ColourModel inner = modelOf(in), outer = modelOf(out);
    result.contrast = contrastBetween(inner, outer);
    VectorXd odds(static_cast<Index>(inside.size()));
    for (std::size_t i = 0; i < inside.size(); ++i)
      odds[static_cast<Index>(i)] = inner.logDensity(region.colours[i]) - outer.logDensity(region.colours[i]);
    const VectorXd x = walked(region, odds, settings.smoothness);
    std::vector<char> next(inside.size());
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = x[static_cast<Index>(i)] > 0.5 ? 1 : 0;
    keepTouching(region, next);
    ++result.rounds;
    const bool same = next == inside;
    inside = std::move(next);
    if (same) break;
  }
  if (result.contrast < settings.leastContrast) {
    result.warnings.emplace_back(
        "colours inside and outside the patch are too much alike; it is left as it was");
    return result;
  }
  result.refined = true;
  result.vertices.clear();
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (inside[i]) result.vertices.push_back(region.vertices[i]);
  return result;
}

}  // namespace falciform
