#include "Logic/Registration/ScanSample.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

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

/// Hands one side from point to point along the tree of smallest bends (Hoppe 1992, by Prim, who adds the
/// point that is cheapest to reach; of equals the first).
void orientAlike(const Points& points, Points& normals) {
  struct Reached {
    Vector3d point, normal;
    double cost = std::numeric_limits<double>::infinity();
    int from = -1;
  };
  std::vector<Reached> all;
  for (Index i = 0; i < points.rows(); ++i)
    all.push_back({points.row(i).transpose(), normals.row(i).transpose()});
  std::vector<int> open(all.size());  // not yet in the tree, in order
  std::iota(open.begin(), open.end(), 0);
  std::size_t next = 0;
  while (!open.empty()) {
    const int row = open[next];
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(next));
    Reached& here = all[static_cast<std::size_t>(row)];
    if (here.from >= 0 && here.normal.dot(all[static_cast<std::size_t>(here.from)].normal) < 0)
      here.normal *= -1;
    double least = std::numeric_limits<double>::infinity();
    next = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      Reached& other = all[static_cast<std::size_t>(open[k])];
      const double bend = 1 - std::abs(here.normal.dot(other.normal));
      const double far = (here.point - other.point).squaredNorm();
      const double price = bend + far / (kNeighbourhoodMm * kNeighbourhoodMm) * 4;
      if (price < other.cost) other.cost = price, other.from = row;
      if (other.cost < least) least = other.cost, next = k;
    }
  }
  for (Index i = 0; i < normals.rows(); ++i)
    normals.row(i) = all[static_cast<std::size_t>(i)].normal.transpose();
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
