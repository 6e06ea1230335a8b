#include "Logic/Registration/ScanSample.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Sampling.h"

namespace falciform {

namespace {

constexpr int kNeighbours = 24, kSpacingNeighbour = 8;
constexpr double kStraggler = 2;         // times the usual spacing
constexpr double kNeighbourhoodMm = 50;  // what counts as far when orientation is handed on
constexpr double kSureBulge = 0.25;      // correlation of place and normal; a sphere's cap has 1

struct LocalPlane {
  Vector3d normal = Vector3d::Zero();
  double spacing = 0;  ///< distance to the 8th neighbour, mm
};

LocalPlane planeAt(const Points& points, const KdTree& tree, int row) {
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
  const auto eighth = std::min<std::size_t>(kSpacingNeighbour, near.size() - 1);
  return {eigen.eigenvectors().col(0), std::sqrt(near[eighth].squaredDistance)};
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
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

ScanSample sampleScan(const LabelledSource& scan, const KdTree& tree, Index others, Index perLabel) {
  std::map<int, std::vector<int>> byLabel;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) byLabel[scan.labels[i]].push_back(static_cast<int>(i));
  std::vector<int> rows;
  for (const auto& [label, ids] : byLabel)
    for (const int k : randomRows(static_cast<Index>(ids.size()), label > 0 ? perLabel : others))
      rows.push_back(ids[static_cast<std::size_t>(k)]);

  std::vector<LocalPlane> planes(rows.size());
  forEachChunk(rows.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) planes[i] = planeAt(scan.points, tree, rows[i]);
  });
  std::vector<double> spacings;
  for (const LocalPlane& plane : planes) spacings.push_back(plane.spacing);
  const double usual = medianOf(spacings);

  ScanSample sample;
  std::vector<int> kept;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (planes[i].spacing <= kStraggler * usual) kept.push_back(static_cast<int>(i));
  sample.points.resize(static_cast<Index>(kept.size()), 3);
  sample.normals.resize(static_cast<Index>(kept.size()), 3);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto from = static_cast<std::size_t>(kept[k]);
    sample.points.row(static_cast<Index>(k)) = scan.points.row(rows[from]);
    sample.normals.row(static_cast<Index>(k)) = planes[from].normal;
    sample.labels.push_back(scan.labels[static_cast<std::size_t>(rows[from])]);
  }
  orientAlike(sample.points, sample.normals);
  const Points about = sample.points.rowwise() - sample.points.colwise().mean();
  const Points turned = sample.normals.rowwise() - sample.normals.colwise().mean();
  const double bulge = about.cwiseProduct(turned).sum(), size = about.norm() * turned.norm();
  if (bulge < 0) sample.normals *= -1;
  sample.outward = std::abs(bulge) > kSureBulge * size;
  return sample;
}

}  // namespace falciform
