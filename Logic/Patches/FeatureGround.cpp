#include "Logic/Patches/FeatureGround.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Sampling.h"
#include "Logic/Geometry/Subdivision.h"
#include "Logic/Patches/CrestStrength.h"

namespace falciform {

namespace {

constexpr Index kFewestVertices = 200;
constexpr double kLongestEdgeMm = 6;            ///< longer ones are cut: a ridge is found to half an edge
constexpr double kSliceMm = 8, kBehindMm = 15;  ///< half a slice; where "behind" has fallen to 1/e
constexpr double kSampleMm = 3;                 ///< of the points that stand for areas
constexpr std::array kScalesMm{8.0, 16.0}, kReachMm{8.0, 12.0}, kBallMm{15.0, 30.0};

/// Triangles turned to face outwards if they face inwards.
void faceOutwards(Surface& surface) {
  Surface centred = surface;
  centred.points.rowwise() -= centroid(surface.points).transpose();
  if (signedVolume(centred) < 0) surface.triangles.col(1).swap(surface.triangles.col(2));
}

/// Place in standard deviations, weighted by area so that the mesh's density does not matter.
void standardise(FeatureGround& ground, const VectorXd& areas) {
  const double total = areas.sum();
  const Eigen::RowVector3d middle = areas.transpose() * ground.turned / total;
  const Points offset = ground.turned.rowwise() - middle;
  ground.spread = (areas.transpose() * offset.cwiseAbs2() / total).cwiseSqrt().transpose();
  if (!(ground.spread.minCoeff() > 0)) throw InputError("the surface is flat; a liver's surface is needed");
  ground.standard = offset.array().rowwise() / ground.spread.transpose().array();
  ground.sizeMm = std::cbrt(ground.spread.prod());
}

/// exp(-behind / 15 mm), "behind" the outermost point along `direction` among those within 8 mm to the sides.
VectorXd outermost(const Points& turned, const Vector3d& direction) {
  const double low = turned.col(0).minCoeff();
  const auto slot = [&](Index i) { return static_cast<std::size_t>(turned(i, 0) - low); };  // of 1 mm
  std::vector<double> highest(static_cast<std::size_t>(turned.col(0).maxCoeff() - low) + 1, -1e30);
  const VectorXd height = turned * direction;
  for (Index i = 0; i < height.size(); ++i) highest[slot(i)] = std::max(highest[slot(i)], height[i]);
  VectorXd result(height.size());
  for (Index i = 0; i < height.size(); ++i) {
    const std::size_t at = slot(i), reach = static_cast<std::size_t>(kSliceMm);
    const auto first = highest.begin() + static_cast<std::ptrdiff_t>(at > reach ? at - reach : 0);
    const auto last = highest.begin() + static_cast<std::ptrdiff_t>(std::min(at + reach + 1, highest.size()));
    result[i] = std::exp((height[i] - *std::max_element(first, last)) / kBehindMm);
  }
  return result;
}

/// Columns: offset of each vertex from the middle of the surface within the ball, over its radius (3), the
/// surface there over a disk's, and the offset along the normal.
Eigen::MatrixXd ballColumns(const Points& turned, const Points& normals, const Points& sample,
                            const VectorXd& weight, const KdTree& tree, double radius) {
  Eigen::MatrixXd columns(turned.rows(), 5);
  forEachChunk(static_cast<std::size_t>(turned.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      double area = 0;
      for (const int j : tree.within(turned.row(i), radius)) {
        middle += weight[j] * sample.row(j);
        area += weight[j];
      }
      Eigen::RowVector3d offset = Eigen::RowVector3d::Zero();
      if (area > 0) offset = (turned.row(i) - middle / area) / radius;
      columns.row(i) << offset, area / (std::numbers::pi * radius * radius), offset.dot(normals.row(i));
    }
  });
  return columns;
}

/// Areas of the vertices gathered at the nearest of the sampled ones.
VectorXd gatheredAreas(const Points& points, const VectorXd& areas, const KdTree& tree, Index samples) {
  VectorXd gathered = VectorXd::Zero(samples);
  for (Index i = 0; i < points.rows(); ++i) gathered[tree.nearest(points.row(i)).index] += areas[i];
  return gathered;
}

}  // namespace

AnatomicalAxes lpsAxes() { return axesFromLetters("LPS"); }

AnatomicalAxes axesFromLetters(const std::string& letters) {
  constexpr std::string_view towards = "RAS", away = "LPI";
  AnatomicalAxes axes;
  axes.rows.setZero();
  for (std::size_t i = 0; i < letters.size() && i < 3; ++i) {
    const std::size_t plus = towards.find(letters[i]), minus = away.find(letters[i]);
    const std::size_t row = std::min(plus, minus);
    if (row < 3) axes.rows(static_cast<Index>(row), static_cast<Index>(i)) = plus < 3 ? 1 : -1;
  }
  if (letters.size() != 3 || std::abs(axes.rows.determinant()) < 0.5)
    throw InputError("the axes are '" + letters +
                     "'; say where x, y and z run by three letters, one of each of R/L, " +
                     "A/P and S/I, as in LPS or RAS");
  return axes;
}

FeatureGround featureGround(const Surface& surface, const AnatomicalAxes& axes, const Progress& progress) {
  if (surface.triangles.rows() == 0)
    throw InputError("features are looked for on triangles, and this is a cloud of points; mesh it first");
  if (surface.size() < kFewestVertices)
    throw InputError("the surface has " + std::to_string(surface.size()) +
                     " vertices; a liver's features need " + std::to_string(kFewestVertices) + " or more");
  progress.report(0, "Curvatures");
  FeatureGround ground;
  ground.axes = axes;
  Surface shape;
  shape.points = surface.points, shape.triangles = surface.triangles, shape.frame = surface.frame;
  ground.surface = subdividedTo(shape, kLongestEdgeMm);
  faceOutwards(ground.surface);
  ground.neighbours = neighboursOfVertices(ground.surface.triangles, ground.surface.size());
  const Points& turned = ground.turned = ground.surface.points * axes.rows.transpose();
  const Points normals = vertexNormals(ground.surface) * axes.rows.transpose();
  const VectorXd areas = vertexAreas(ground.surface);
  standardise(ground, areas);

  Eigen::MatrixXd& d = ground.descriptors;
  d.resize(turned.rows(), kDescriptors);
  d.leftCols(3) = ground.standard;
  d.middleCols(3, 3) = normals;
  Index column = 6;
  for (std::size_t s = 0; s < kScalesMm.size(); ++s) {
    CurvatureSettings settings;
    settings.radiusMm = kScalesMm[s];
    const Curvatures curvatures = principalCurvatures(ground.surface, settings);
    const auto squashed = [&](const VectorXd& k) -> VectorXd {
      return k.unaryExpr([&](double v) { return std::isfinite(v) ? std::tanh(v * kScalesMm[s]) : 0.0; });
    };
    d.col(column++) = squashed(curvatures.k1);
    d.col(column++) = squashed(curvatures.k2);
    const auto peak = [&](CrestKind kind) -> VectorXd {
      return crestPeak(ground.surface, curvatures, kind, kReachMm[s])
          .cwiseProduct(squashed(crestCurvature(curvatures, kind)));
    };
    d.col(14 + static_cast<Index>(s)) = peak(CrestKind::Ridge);
    if (s == 0) d.col(16) = peak(CrestKind::Valley);
    progress.report(0.4 * static_cast<double>(s + 1), "Curvatures");
  }
  for (const double angleDeg : {0.0, 30.0, 60.0, 90.0}) {
    const double angle = angleDeg * std::numbers::pi / 180;
    d.col(column++) = outermost(turned, Vector3d(0, std::sin(angle), -std::cos(angle)));
  }
  const Points sample = rowsOf(turned, voxelSample(turned, kSampleMm));
  const KdTree tree(sample);
  const VectorXd weight = gatheredAreas(turned, areas, tree, sample.rows());
  column = 17;
  for (const double radius : kBallMm) {
    d.middleCols(column, 5) = ballColumns(turned, normals, sample, weight, tree, radius);
    column += 5;
  }
  progress.report(1, "Curvatures");
  return ground;
}

}  // namespace falciform
