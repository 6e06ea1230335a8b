#include "Logic/Atlas/DeformedSurface.h"

#include <cmath>
#include <numeric>

#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"
#include "Logic/Geometry/TrianglePlaces.h"

namespace falciform {
namespace {

/// Rows of `linear` for `nodes`: the sum of all loads' answers.
void addUp(const Eigen::MatrixXf& responses, const VectorXd& coefficients, const std::vector<int>& nodes,
           Points& linear) {
  const Eigen::VectorXf q = coefficients.cast<float>();
  forEachChunk(nodes.size(), 512, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Index node = nodes[i];
      const Eigen::Vector3f moved = responses.middleCols<3>(3 * node).transpose() * q;
      linear.row(node) = moved.cast<double>().transpose();
    }
  });
}

CornerWarp::Change noTurns(Index nodes) { return {Points::Zero(nodes, 3), Points::Zero(nodes, 3)}; }

}  // namespace

BentNodes bendAll(const UpdateModel& model, const VectorXd& coefficients, bool trueTurns) {
  BentNodes bent;
  bent.displacements.resize(model.responses().mesh.nodes(), 3);
  std::vector<int> all(static_cast<std::size_t>(bent.displacements.rows()));
  std::iota(all.begin(), all.end(), 0);
  addUp(model.responses().responses, coefficients, all, bent.displacements);
  CornerWarp::Change change =
      trueTurns ? model.warp().apply(bent.displacements) : noTurns(bent.displacements.rows());
  bent.displacements += change.added;
  bent.turns = std::move(change.turns);
  return bent;
}

DeformedSurface::DeformedSurface(const UpdateModel& model, const UpdateSettings& settings)
    : model_(model),
      painted_(settings.patchWeight > 0),
      trueTurns_(settings.trueTurns),
      linear_(Points::Zero(model.responses().mesh.nodes(), 3)) {}

void DeformedSurface::choose(const VectorXd& coefficients, const KdTree& scan, double reachMm) {
  centres_ = model_.responses().centres +
             Points(model_.centres().interpolate(bendAll(model_, coefficients, trueTurns_).displacements));
  std::vector<char> near(static_cast<std::size_t>(centres_.rows()));
  for (Index c = 0; c < centres_.rows(); ++c)
    near[static_cast<std::size_t>(c)] =
        scan.nearest(centres_.row(c).transpose(), reachMm * reachMm).index >= 0 ? 1 : 0;
  keepPart(near);
  bend(coefficients);
  refreshTrees();
}

void DeformedSurface::keepPart(const std::vector<char>& nearCentre) {
  const Surface& fine = model_.fine();
  std::vector<int> placeOf(static_cast<std::size_t>(fine.size()), -1);
  std::vector<char> wanted(static_cast<std::size_t>(linear_.rows()), 0);
  for (const int corner : model_.warp().corners()) wanted[static_cast<std::size_t>(corner)] = 1;
  vertices_.clear();
  for (int v = 0; v < static_cast<int>(fine.size()); ++v) {
    if (nearCentre[static_cast<std::size_t>(model_.centreOf()[static_cast<std::size_t>(v)])] == 0) continue;
    placeOf[static_cast<std::size_t>(v)] = static_cast<int>(vertices_.size());
    vertices_.push_back(v);
    for (Index k = 0; k < model_.places().nodes().cols(); ++k)
      wanted[static_cast<std::size_t>(model_.places().nodes()(v, k))] = 1;
  }
  nodes_.clear();
  for (std::size_t n = 0; n < wanted.size(); ++n)
    if (wanted[n] != 0) nodes_.push_back(static_cast<int>(n));
  triangles_.resize(fine.triangles.rows(), 3);
  Index kept = 0;
  for (Index t = 0; t < fine.triangles.rows(); ++t) {
    Eigen::RowVector3i corners;
    for (int k = 0; k < 3; ++k) corners[k] = placeOf[static_cast<std::size_t>(fine.triangles(t, k))];
    if (corners.minCoeff() >= 0) triangles_.row(kept++) = corners;
  }
  triangles_.conservativeResize(kept, 3);
  fanBegin_.assign(vertices_.size() + 1, 0);
  for (Index t = 0; t < kept; ++t)
    for (int k = 0; k < 3; ++k) ++fanBegin_[static_cast<std::size_t>(triangles_(t, k)) + 1];
  std::partial_sum(fanBegin_.begin(), fanBegin_.end(), fanBegin_.begin());
  fans_.resize(static_cast<std::size_t>(fanBegin_.back()));
  std::vector<int> next(fanBegin_.begin(), fanBegin_.end() - 1);
  for (Index t = 0; t < kept; ++t)
    for (int k = 0; k < 3; ++k)
      fans_[static_cast<std::size_t>(next[static_cast<std::size_t>(triangles_(t, k))]++)] =
          static_cast<int>(t);
}

void DeformedSurface::bend(const VectorXd& coefficients) {
  addUp(model_.responses().responses, coefficients, nodes_, linear_);
  place();
}

/// Points, turns and normals. Normals are weighted by area: cheap, and the vertices lie evenly.
void DeformedSurface::place() {
  const CornerWarp::Change change = trueTurns_ ? model_.warp().apply(linear_) : noTurns(linear_.rows());
  const MeshPlaces& places = model_.places();
  points_.resize(static_cast<Index>(vertices_.size()), 3);
  turns_.resize(vertices_.size());
  forEachChunk(vertices_.size(), 2048, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Index v = vertices_[i];
      Eigen::RowVector3d at = model_.fine().points.row(v), turn = Eigen::RowVector3d::Zero();
      for (Index k = 0; k < places.nodes().cols(); ++k) {
        const int node = places.nodes()(v, k);
        at += places.weights()(v, k) * (linear_.row(node) + change.added.row(node));
        turn += places.weights()(v, k) * change.turns.row(node);
      }
      points_.row(static_cast<Index>(i)) = at;
      turns_[i] = rotationOf(turn.transpose());
    }
  });
  normals_.setZero(points_.rows(), 3);
  for (Index t = 0; t < triangles_.rows(); ++t) {
    const int a = triangles_(t, 0), b = triangles_(t, 1), c = triangles_(t, 2);
    const Eigen::RowVector3d across =
        (points_.row(b) - points_.row(a)).cross(points_.row(c) - points_.row(a));
    for (const int corner : {a, b, c}) normals_.row(corner) += across;
  }
  normals_.rowwise().normalize();
}

void DeformedSurface::refreshTrees() {
  tree_ = KdTree(points_);
  patches_.clear();
  if (!painted_) return;
  for (const int label : patchLabels(model_.fine())) {
    std::vector<int> places;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      if (model_.fine().patchAt(vertices_[i]) == label) places.push_back(static_cast<int>(i));
    if (!places.empty()) patches_.emplace_back(label, KdTree(points_, places));
  }
}

/// Of the triangles around a place, those alone that have `label` at all three corners, if it is not -1.
SurfaceMeeting DeformedSurface::around(int nearest, const Vector3d& y, int label) const {
  SurfaceMeeting best{nearest, points_.row(nearest).transpose(), normals_.row(nearest).transpose(), 0};
  double least = (y - best.point).squaredNorm();
  for (int at = fanBegin_[static_cast<std::size_t>(nearest)];
       at < fanBegin_[static_cast<std::size_t>(nearest) + 1]; ++at) {
    const int t = fans_[static_cast<std::size_t>(at)];
    const int a = triangles_(t, 0), b = triangles_(t, 1), c = triangles_(t, 2);
    if (label >= 0) {
      bool inside = true;
      for (const int corner : {a, b, c}) inside = inside && model_.fine().patchAt(vertex(corner)) == label;
      if (!inside) continue;
    }
    const Corners corners{points_.row(a), points_.row(b), points_.row(c)};
    const PlaceOnTriangle place = closestPlace(y, corners);
    if (!(place.squaredDistance < least)) continue;
    least = place.squaredDistance;
    best.point = place.point;
    best.normal = (place.barycentric[0] * normals_.row(a) + place.barycentric[1] * normals_.row(b) +
                   place.barycentric[2] * normals_.row(c))
                      .transpose()
                      .normalized();
  }
  best.distance = std::sqrt(least);
  return best;
}

SurfaceMeeting DeformedSurface::closest(const Vector3d& y) const {
  return around(tree_.nearest(y).index, y, -1);
}

SurfaceMeeting DeformedSurface::closestOfPatch(std::size_t patch, const Vector3d& y) const {
  return around(patches_[patch].second.nearest(y).index, y, patches_[patch].first);
}

}  // namespace falciform
