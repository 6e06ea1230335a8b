#include "Logic/Registration/ScanSample.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "Logic/Core/Median.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"

namespace falciform {

namespace {

constexpr int kNeighbours = 24, kSpacingNeighbour = 8;
constexpr double kStraggler =
    3;  // times the usual spacing; grazing parts of a range scan are twice as sparse
constexpr double kNeighbourhoodMm = 50;  // what counts as far when orientation is handed on
constexpr double kSureBulge = 0.25;      // correlation of place and normal; a sphere's cap has 1

Vector3d normalAt(const Points& points, const KdTree& tree, int row) {
  const std::vector<Neighbour> near = tree.nearest(Vector3d(points.row(row).transpose()), kNeighbours);
  Vector3d mean = Vector3d::Zero();
  for (const Neighbour& n : near) mean += points.row(n.index).transpose();
  mean /= static_cast<double>(near.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Neighbour& n : near) {
    const Vector3d d = points.row(n.index).transpose() - mean;
    spread += d * d.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
  eigen.computeDirect(spread);
  return eigen.eigenvectors().col(0);
}

/// Hands one side from point to point along the tree of smallest bends (Hoppe 1992, by Prim).
void orientAlike(const Points& points, Points& normals) {
  const auto n = static_cast<std::size_t>(points.rows());
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<int> from(n, -1);
  std::vector<char> done(n, 0);
  cost[0] = 0;
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t next = n;
    for (std::size_t i = 0; i < n; ++i)
      if (!done[i] && (next == n || cost[i] < cost[next])) next = i;
    done[next] = 1;
    const auto here = static_cast<Index>(next);
    if (from[next] >= 0 && normals.row(here).dot(normals.row(from[next])) < 0) normals.row(here) *= -1;
    for (std::size_t i = 0; i < n; ++i) {
      if (done[i]) continue;
      const auto other = static_cast<Index>(i);
      const double bend = 1 - std::abs(normals.row(here).dot(normals.row(other)));
      const double far = (points.row(here) - points.row(other)).squaredNorm();
      const double price = bend + far / (kNeighbourhoodMm * kNeighbourhoodMm) * 4;
      if (price < cost[i]) cost[i] = price, from[i] = static_cast<int>(next);
    }
  }
}

}  // namespace

std::vector<int> withoutStragglers(const Points& points, const KdTree& tree, const std::vector<int>& rows) {
  std::vector<double> spacings(rows.size());
  forEachChunk(rows.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3d place = points.row(rows[i]).transpose();
      spacings[i] = std::sqrt(tree.nearest(place, kSpacingNeighbour + 1).back().squaredDistance);
    }
  });
  if (rows.empty()) return rows;
  std::vector<double> sorted = spacings;
  const double usual = medianInPlace(sorted);
  std::vector<int> kept;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (spacings[i] <= kStraggler * usual) kept.push_back(rows[i]);
  return kept;
}

ScanSample sampleScan(const LabelledSource& scan, const KdTree& tree, Index others, Index perLabel) {
  std::map<int, std::vector<int>> byLabel;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) byLabel[scan.labels[i]].push_back(static_cast<int>(i));
  std::vector<int> rows;
  for (const auto& [label, ids] : byLabel)
    for (const int k : randomRows(static_cast<Index>(ids.size()), label > 0 ? perLabel : others))
      rows.push_back(ids[static_cast<std::size_t>(k)]);

  rows = withoutStragglers(scan.points, tree, rows);
  ScanSample sample;
  sample.points = rowsOf(scan.points, rows);
  sample.normals.resize(sample.points.rows(), 3);
  forEachChunk(rows.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      sample.normals.row(static_cast<Index>(i)) = normalAt(scan.points, tree, rows[i]);
  });
  for (const int i : rows) sample.labels.push_back(scan.labels[static_cast<std::size_t>(i)]);
  orientAlike(sample.points, sample.normals);
  const Points about = sample.points.rowwise() - sample.points.colwise().mean();
  const Points turned = sample.normals.rowwise() - sample.normals.colwise().mean();
  const double bulge = about.cwiseProduct(turned).sum(), size = about.norm() * turned.norm();
  if (bulge < 0) sample.normals *= -1;
  sample.outward = std::abs(bulge) > kSureBulge * size;
  return sample;
}

}  // namespace falciform
