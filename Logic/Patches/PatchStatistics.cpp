#include "Logic/Patches/PatchStatistics.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Sampling.h"

namespace falciform {

namespace {

constexpr Index kFewPoints = 20;

/// Merges numbers into groups.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      int& parent = parent_[static_cast<std::size_t>(i)];
      parent = parent_[static_cast<std::size_t>(parent)];
      i = parent;
    }
    return i;
  }
  void join(int a, int b) {
    parent_[static_cast<std::size_t>(std::max(find(a), find(b)))] = std::min(find(a), find(b));
  }

 private:
  std::vector<int> parent_;
};

/// Number of pieces of a label, by edges whose two ends bear it.
int piecesByEdges(const Surface& surface, int label) {
  Groups groups(static_cast<std::size_t>(surface.size()));
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles(t, k), b = surface.triangles(t, (k + 1) % 3);
      if (surface.patchAt(a) == label && surface.patchAt(b) == label) groups.join(a, b);
    }
  int pieces = 0;
  for (const int id : pointsOfPatch(surface, label)) pieces += groups.find(id) == id ? 1 : 0;
  return pieces;
}

/// Number of pieces of a set of points, linked where closer than three mean distances to the nearest
/// neighbour.
int piecesBySpacing(const Points& points) {
  const KdTree tree(points);
  double sum = 0;
  for (Index i = 0; i < points.rows(); ++i) {
    const std::vector<Neighbour> two = tree.nearest(points.row(i).transpose(), 2);
    if (two.size() == 2) sum += std::sqrt(two[1].squaredDistance);
  }
  const double link = 3 * sum / static_cast<double>(points.rows());
  Groups groups(static_cast<std::size_t>(points.rows()));
  for (Index i = 0; i < points.rows(); ++i)
    for (const int j : tree.within(points.row(i).transpose(), link)) groups.join(static_cast<int>(i), j);
  int pieces = 0;
  for (int i = 0; i < points.rows(); ++i) pieces += groups.find(i) == i ? 1 : 0;
  return pieces;
}

/// Extents along the longest and the second principal axis.
std::pair<double, double> principalExtents(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  const Matrix3d scatter = centred.transpose() * centred;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(scatter);  // ascending
  const auto extent = [&](int axis) {
    const VectorXd along = centred * axes.eigenvectors().col(axis);
    return along.maxCoeff() - along.minCoeff();
  };
  return {extent(2), extent(1)};
}

}  // namespace

std::vector<PatchStatistics> patchStatistics(const Surface& surface) {
  const bool mesh = surface.triangles.rows() > 0;
  const VectorXd areas = mesh ? vertexAreas(surface) : VectorXd();
  std::vector<PatchStatistics> rows;
  for (const int label : patchLabels(surface)) {
    const std::vector<int> ids = pointsOfPatch(surface, label);
    const Points points = rowsOf(surface.points, ids);
    PatchStatistics row;
    row.label = label;
    row.name = patchName(surface, label);
    row.points = points.rows();
    if (mesh)
      for (const int id : ids) row.areaMm2 += areas[id];
    std::tie(row.lengthMm, row.widthMm) = principalExtents(points);
    row.pieces = mesh ? piecesByEdges(surface, label) : piecesBySpacing(points);
    row.centroid = points.colwise().mean();
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> patchWarnings(const Surface& preop, const Surface& scan) {
  const std::vector<int> onPreop = patchLabels(preop), onScan = patchLabels(scan);
  if (onPreop.empty() && onScan.empty())
    return {
        "No patches are painted, so the registration has no features to go by: paint the falciform and the "
        "ridge on both surfaces."};
  std::vector<std::string> warnings;
  std::set<int> all(onPreop.begin(), onPreop.end());
  all.insert(onScan.begin(), onScan.end());
  for (const int label : all) {
    const Index preopPoints = static_cast<Index>(pointsOfPatch(preop, label).size());
    const Index scanPoints = static_cast<Index>(pointsOfPatch(scan, label).size());
    const std::string name = patchName(preopPoints > 0 ? preop : scan, label);
    const auto few = [&](Index points, const std::string& side) {
      if (points > 0 && points < kFewPoints)
        warnings.push_back("Patch '" + name + "' has only " + std::to_string(points) +
                           (points == 1 ? " point" : " points") + " on the " + side + "; paint at least " +
                           std::to_string(kFewPoints) + ".");
    };
    if (preopPoints == 0 || scanPoints == 0)
      warnings.push_back("Patch '" + name + "' is painted only on the " +
                         (scanPoints == 0 ? "pre-operative surface; paint it on the scan too, or erase it."
                                          : "scan; paint it on the pre-operative surface too, or erase it."));
    few(preopPoints, "pre-operative surface");
    few(scanPoints, "scan");
  }
  return warnings;
}

}  // namespace falciform
