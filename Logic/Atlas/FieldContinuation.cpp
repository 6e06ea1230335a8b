#include "Logic/Atlas/FieldContinuation.h"

#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr double kMostNodes = 150000, kFinestCellMm = 5;
constexpr std::size_t kChunk = 256;

/// One sample a boundary face.
struct Samples {
  Eigen::ArrayX3d places, displacements;
  Eigen::ArrayXd areas;
  double largestMm = 0;
};

Samples samplesOf(const TetrahedralMesh& mesh, const Points& displacements) {
  const BoundaryFaces faces = boundaryFaces(mesh);
  Samples samples{faceCentres(mesh, faces).array(), Eigen::ArrayX3d::Zero(faces.size(), 3),
                  faces.areaVectors.rowwise().norm().array()};
  // Shape functions in the middle of a triangle of 3 nodes, or of 6.
  const double corner = faces.quadratic ? -1.0 / 9 : 1.0 / 3, edge = 4.0 / 9;
  for (Index f = 0; f < faces.size(); ++f)
    for (int k = 0; k < faces.nodesPerFace(); ++k) {
      const auto moved = displacements.row(faces.nodes(f, k));
      samples.displacements.row(f) += (k < 3 ? corner : edge) * moved.array();
      samples.largestMm = std::max(samples.largestMm, moved.norm());
    }
  return samples;
}

Vector3d meanAt(const Samples& samples, const Vector3d& place, double bandMm) {
  const Eigen::ArrayXd squared = (samples.places.col(0) - place.x()).square() +
                                 (samples.places.col(1) - place.y()).square() +
                                 (samples.places.col(2) - place.z()).square() + bandMm * bandMm;
  const Eigen::ArrayXd weights = samples.areas / squared.square();
  return (samples.displacements.colwise() * weights).colwise().sum().matrix().transpose() / weights.sum();
}

}  // namespace

FieldContinuation::FieldContinuation(const MeshLocator& locator, const Points& displacements,
                                     const ContinuationPlan& plan) {
  const TetrahedralMesh& mesh = locator.mesh();
  const Samples samples = samplesOf(mesh, displacements);
  marginMm_ = std::max(plan.leastMarginMm, plan.marginPerMm * samples.largestMm);
  const Vector3d low = mesh.points.colwise().minCoeff().transpose().array() - marginMm_,
                 high = mesh.points.colwise().maxCoeff().transpose().array() + marginMm_;
  cellMm_ = std::max(kFinestCellMm, std::cbrt((high - low).prod() / kMostNodes));
  origin_ = low.array() - cellMm_;
  counts_ = ((high - low) / cellMm_).array().ceil().cast<int>() + 3;  // a rim of zeros all around
  const auto nodes = static_cast<std::size_t>(counts_.cast<Index>().prod());
  values_.assign(nodes, Vector3d::Zero());
  nearBand_.resize(nodes);
  // Distance grows by no more than 1 a mm, and a place is within half a diagonal of some corner of its cell.
  const double reach = plan.bandMm + std::sqrt(0.75) * cellMm_;
  forEachChunk(nodes, kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto nx = static_cast<std::size_t>(counts_.x()), ny = static_cast<std::size_t>(counts_.y());
      const Vector3d node(static_cast<double>(n % nx), static_cast<double>(n / nx % ny),
                          static_cast<double>(n / nx / ny));
      const Vector3d place = origin_ + cellMm_ * node;
      const double outside = locator.find(place).outsideMm, t = std::min(1.0, outside / marginMm_);
      nearBand_[n] = outside <= reach ? 1 : 0;
      if (t < 1) values_[n] = (1 - t * t * (3 - 2 * t)) * meanAt(samples, place, plan.bandMm);
    }
  });
}

std::size_t FieldContinuation::index(const Vector3i& node) const {
  return (static_cast<std::size_t>(node.z()) * static_cast<std::size_t>(counts_.y()) +
          static_cast<std::size_t>(node.y())) *
             static_cast<std::size_t>(counts_.x()) +
         static_cast<std::size_t>(node.x());
}

FieldContinuation::Value FieldContinuation::at(const Vector3d& place) const {
  const Vector3d at = (place - origin_) / cellMm_;
  Value value;
  if (!((at.array() >= 0).all() && (at.array() < (counts_.array() - 1).cast<double>()).all())) return value;
  const Vector3i cell = at.cast<int>();
  const Vector3d t = at - cell.cast<double>();
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3i step(corner & 1, corner >> 1 & 1, corner >> 2);
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? t[axis] : 1 - t[axis];
    const std::size_t node = index(cell + step);
    value.displacement += weight * values_[node];
    value.near = value.near || nearBand_[node] != 0;
  }
  return value;
}

}  // namespace falciform
