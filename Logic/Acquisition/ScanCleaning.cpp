#include "Logic/Acquisition/ScanCleaning.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 512;
constexpr double kSigmaOfMad = 1.4826;  // of a normal distribution
constexpr double kSparser = 2;          // times the neighbours' own spacing, and the scan's usual one
constexpr double kBend = 3;             // times the distances of those around from their planes
constexpr double kNoRaster = 6;         // times the usual one: a raster at 80 degrees is 5.8 times as wide

/// How a point stands to those around it.
struct Standing {
  double spacing = 0;   ///< mean distance to its neighbours, mm
  double offPlane = 0;  ///< distance to the plane through them, mm
  std::vector<int> around;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Standing standingOf(const Points& points, int i, const std::vector<Neighbour>& near) {
  Standing standing;
  Vector3d mean = Vector3d::Zero();
  for (const Neighbour& other : near) {
    if (other.index == i) continue;
    standing.around.push_back(other.index);
    standing.spacing += std::sqrt(other.squaredDistance);
    mean += points.row(other.index).transpose();
  }
  const auto count = static_cast<double>(standing.around.size());
  if (count < 4) return standing;  // three make a plane of themselves
  standing.spacing /= count;
  mean /= count;
  Matrix3d squares = Matrix3d::Zero();
  for (const int j : standing.around) {
    const Vector3d d = points.row(j).transpose() - mean;
    squares += d * d.transpose();
  }
  const Vector3d normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(squares).eigenvectors().col(0);
  standing.offPlane = std::abs(normal.dot(points.row(i).transpose() - mean));
  return standing;
}

std::vector<char> pointsOfTriangles(const Surface& scan) {
  std::vector<char> used(static_cast<std::size_t>(scan.size()), scan.triangles.rows() == 0);
  for (const int v : scan.triangles.reshaped()) used[static_cast<std::size_t>(v)] = 1;
  return used;
}

std::vector<char> findOutliers(const Surface& scan, const CleaningPlan& plan, const Progress& progress) {
  const auto n = static_cast<std::size_t>(scan.size());
  const std::vector<char> used = pointsOfTriangles(scan);
  std::vector<char> outlier(n);
  std::vector<int> ids;
  for (std::size_t i = 0; i < n; ++i) {
    outlier[i] = !used[i];
    if (used[i]) ids.push_back(static_cast<int>(i));
  }
  if (static_cast<int>(ids.size()) <= plan.outlierNeighbours) return outlier;
  const KdTree tree(scan.points, ids);
  std::vector<Standing> standings(n);
  forEachChunk(ids.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const int i = ids[k];
      standings[static_cast<std::size_t>(i)] = standingOf(
          scan.points, i, tree.nearest(scan.points.row(i).transpose(), plan.outlierNeighbours + 1));
    }
  });
  progress.report(0.7, "Outliers");
  std::vector<double> spacings, offPlane;
  for (const int i : ids) {
    spacings.push_back(standings[static_cast<std::size_t>(i)].spacing);
    offPlane.push_back(standings[static_cast<std::size_t>(i)].offPlane);
  }
  const double usual = median(spacings);
  // Of a normal distribution about 0 the median distance is that of the absolute deviations. An exact plane
  // has none: a thousandth of the spacing is rounding.
  const double sigma = std::max(kSigmaOfMad * median(offPlane), 1e-3 * usual);
  forEachChunk(ids.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    std::vector<double> theirs, bends;
    for (std::size_t k = begin; k < end; ++k) {
      const auto i = static_cast<std::size_t>(ids[k]);
      theirs.clear();
      bends.clear();
      for (const int j : standings[i].around) {
        theirs.push_back(standings[static_cast<std::size_t>(j)].spacing);
        bends.push_back(standings[static_cast<std::size_t>(j)].offPlane);
      }
      const bool apart = standings[i].spacing > kNoRaster * usual ||
                         (!theirs.empty() && standings[i].spacing > kSparser * usual &&
                          standings[i].spacing > kSparser * median(theirs));
      // Where the surface itself bends, all around are off their planes.
      const bool off = !bends.empty() && standings[i].offPlane > plan.outlierSpread * sigma &&
                       standings[i].offPlane > kBend * median(bends);
      outlier[i] = apart || off;
    }
  });
  return outlier;
}

/// Of the triangles whose corners are all left: a spike turns the others around it.
Points normalsOf(const Surface& scan, const std::vector<char>& left) {
  if (scan.triangles.rows() == 0) return scan.normals;
  Surface sound;
  sound.points = scan.points;
  sound.triangles.resize(scan.triangles.rows(), 3);
  Index count = 0;
  for (Index t = 0; t < scan.triangles.rows(); ++t) {
    const auto corners = scan.triangles.row(t);
    if (left[static_cast<std::size_t>(corners[0])] && left[static_cast<std::size_t>(corners[1])] &&
        left[static_cast<std::size_t>(corners[2])])
      sound.triangles.row(count++) = corners;
  }
  sound.triangles.conservativeResize(count, 3);
  return vertexNormals(sound);
}

/// The mean over each point and those around it, twice: noise turns single triangles any way.
Points smoothedOver(const Adjacency& neighbours, const std::vector<char>& left, Points normals) {
  for (int time = 0; time < 2; ++time) {
    Points mean = normals;
    for (int i = 0; i < static_cast<int>(normals.rows()); ++i)
      for (const int* j = neighbours.begin(i); j != neighbours.end(i); ++j)
        if (left[static_cast<std::size_t>(*j)]) mean.row(i) += normals.row(*j);
    for (Index i = 0; i < mean.rows(); ++i)
      if (const double length = mean.row(i).norm(); length > 0) mean.row(i) /= length;
    normals.swap(mean);
  }
  return normals;
}

std::vector<char> findGrazing(const Surface& scan, const Adjacency& neighbours,
                              const Vector3d& towardsScanner, double grazingDeg,
                              const std::vector<char>& left) {
  std::vector<char> grazing(left.size());
  const double flattest = std::cos(grazingDeg * std::numbers::pi / 180);
  const Points normals = smoothedOver(neighbours, left, normalsOf(scan, left));
  for (Index i = 0; i < normals.rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    grazing[k] = left[k] && !normals.row(i).isZero() && normals.row(i).dot(towardsScanner) < flattest;
  }
  return grazing;
}

}  // namespace

FalseReturns findFalseReturns(const Surface& scan, const Adjacency& neighbours,
                              const Vector3d& towardsScanner, const CleaningPlan& plan,
                              const Progress& progress) {
  const auto n = static_cast<std::size_t>(scan.size());
  FalseReturns found{std::vector<char>(n), std::vector<char>(n), std::vector<char>(n)};
  std::vector<char> left(n, 1);
  const auto take = [&](const std::vector<char>& marked) {
    for (std::size_t i = 0; i < n; ++i) left[i] = left[i] && !marked[i];
  };
  progress.report(0, "Outliers");
  if (plan.outlierSpread > 0) found.outlier = findOutliers(scan, plan, progress.part(0, 0.8));
  take(found.outlier);
  progress.report(0.8, "Grazing returns");
  if (plan.grazingDeg < 90)
    found.grazing = findGrazing(scan, neighbours, towardsScanner, plan.grazingDeg, left);
  take(found.grazing);
  progress.report(0.9, "Small pieces");
  if (plan.smallestPieceShare > 0) {
    const ScanPieces pieces = scanPieces(scan, neighbours, left);
    const int largest = pieces.largest();
    for (std::size_t i = 0; i < n && largest >= 0; ++i)
      found.smallPiece[i] =
          left[i] && pieces.areaMm2[static_cast<std::size_t>(pieces.of[i])] <
                         plan.smallestPieceShare * pieces.areaMm2[static_cast<std::size_t>(largest)];
  }
  progress.report(1);
  return found;
}

}  // namespace falciform
