#include "Logic/Atlas/DeformedMesh.h"

#include <algorithm>

#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

/// A place on a shared face may lie outside both elements by rounding: barycentric.
constexpr double kInside = -1e-10;
constexpr int kSteps = 25;
/// mm: rounding of coordinates of a metre stays below a thousandth of it.
constexpr double kExactMm = 1e-10;

Eigen::Vector4d fromLastThree(const Vector3d& b) { return {1 - b.sum(), b.x(), b.y(), b.z()}; }

}  // namespace

DeformedMesh::DeformedMesh(const TetrahedralMesh& mesh, const Points& displacements)
    : quadratic_(mesh.quadratic()) {
  checkMesh(mesh, "the mesh");
  if (displacements.rows() != mesh.nodes() || !displacements.allFinite())
    throw InputError("the mesh has " + std::to_string(mesh.nodes()) + " nodes, the deformation " +
                     std::to_string(displacements.rows()) + " finite displacements; give one a node");
  elements_.reserve(static_cast<std::size_t>(mesh.size()));
  low_.resize(mesh.size(), 3);
  high_.resize(mesh.size(), 3);
  for (Index e = 0; e < mesh.size(); ++e) add(mesh, displacements, e);
  lowest_ = low_.colwise().minCoeff().transpose();
  highest_ = high_.colwise().maxCoeff().transpose();
  boxes_.emplace(low_, high_);
}

void DeformedMesh::add(const TetrahedralMesh& mesh, const Points& displacements, Index e) {
  Eigen::Matrix<double, 3, 4> before, after;
  for (int k = 0; k < 4; ++k) {
    const int node = mesh.elements(e, k);
    before.col(k) = mesh.points.row(node).transpose();
    after.col(k) = before.col(k) + displacements.row(node).transpose();
  }
  Element element;
  element.origin = after.col(0);
  element.before = before.col(0);
  element.edges = after.rightCols<3>().colwise() - element.origin;
  element.edgesBefore = before.rightCols<3>().colwise() - element.before;
  element.inverse = element.edges.inverse();
  // Corners pressed flat have no inverse: then nothing is ruled out beforehand.
  const bool flat = !element.inverse.allFinite();
  if (flat) element.inverse.setZero();
  element.bends.setZero();
  if (quadratic_)
    for (int k = 0; k < 6; ++k) {
      const auto [a, b] = kTetrahedronEdges[static_cast<std::size_t>(k)];
      const auto moved = [&](int node) {
        return Vector3d(displacements.row(mesh.elements(e, node)).transpose());
      };
      element.bends.col(k) = 4 * (moved(4 + k) - (moved(a) + moved(b)) / 2);
    }
  // The sum of b_i b_j over the six edges is 3/8 at most.
  const Vector3d reach = 0.375 * element.bends.cwiseAbs().rowwise().maxCoeff();
  const double size = element.edges.cwiseAbs().maxCoeff();
  low_.row(e) = (after.rowwise().minCoeff() - reach).transpose().array() - 1e-9 * size;
  high_.row(e) = (after.rowwise().maxCoeff() + reach).transpose().array() + 1e-9 * size;
  const double longest = 0.375 * element.bends.colwise().norm().maxCoeff();
  Eigen::Vector4d perMm;
  perMm << element.inverse.colwise().sum().norm(), element.inverse.rowwise().norm();
  element.slack = flat ? 1e9 : longest * perMm.maxCoeff() + 1e-9;
  elements_.push_back(element);
}

Vector3d DeformedMesh::bend(const Element& element, const Eigen::Vector4d& b) const {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = kTetrahedronEdges[static_cast<std::size_t>(k)];
    sum += b[i] * b[j] * element.bends.col(k);
  }
  return sum;
}

Matrix3d DeformedMesh::slope(const Element& element, const Eigen::Vector4d& b) const {
  if (!quadratic_) return element.edges;
  Eigen::Matrix<double, 3, 4> by = Eigen::Matrix<double, 3, 4>::Zero();
  for (int k = 0; k < 6; ++k) {
    const auto [i, j] = kTetrahedronEdges[static_cast<std::size_t>(k)];
    by.col(i) += b[j] * element.bends.col(k);
    by.col(j) += b[i] * element.bends.col(k);
  }
  return element.edges + Matrix3d(by.rightCols<3>().colwise() - by.col(0));
}

Vector3d DeformedMesh::now(int e, const Eigen::Vector4d& barycentric, const Vector3d& beyond) const {
  const Element& element = elements_[static_cast<std::size_t>(e)];
  Vector3d place = element.origin + element.edges * barycentric.tail<3>();
  if (quadratic_) place += bend(element, barycentric);
  if (!beyond.isZero(0))
    place += slope(element, barycentric) * element.edgesBefore.partialPivLu().solve(beyond);
  return place;
}

std::optional<Eigen::Vector4d> DeformedMesh::solve(const Element& element, const Vector3d& now) const {
  Vector3d b = element.inverse * (now - element.origin);
  Eigen::Vector4d place = fromLastThree(b);
  if (!(place.minCoeff() >= kInside - element.slack)) return {};
  if (!quadratic_) return place.minCoeff() >= kInside ? std::optional(place) : std::nullopt;
  // From the straight element's answer; where that leads astray, from its middle.
  for (const bool again : {false, true}) {
    if (again) place.setConstant(0.25);
    for (int step = 0; step < kSteps; ++step) {
      b = place.tail<3>();
      const Vector3d miss = element.origin + element.edges * b + bend(element, place) - now;
      if (miss.squaredNorm() < kExactMm * kExactMm) {
        if (place.minCoeff() >= kInside) return place;
        break;
      }
      const Vector3d change = slope(element, place).inverse() * miss;
      if (!(change.cwiseAbs().maxCoeff() < 10)) break;
      place = fromLastThree(b - change);
    }
    // Far outside: the other start would not end inside.
    if (place.allFinite() && place.minCoeff() < -0.5 - element.slack) return {};
  }
  return {};
}

std::optional<DeformedMesh::Tissue> DeformedMesh::find(const Vector3d& now, int guess) const {
  Tissue best;
  double deepest = 0;
  const auto take = [&](int e) {
    const Element& element = elements_[static_cast<std::size_t>(e)];
    const std::optional<Eigen::Vector4d> place = solve(element, now);
    if (!place) return;
    const double depth = place->minCoeff();
    if (best.element >= 0 && (depth < deepest || (depth == deepest && e > best.element))) return;
    deepest = depth;
    best.element = e;
    best.barycentric = *place;
  };
  if (guess >= 0 && guess < size()) take(guess);
  const double within = 0;  // of the boxes: those that hold the place
  if (best.element < 0)
    boxes_->visitNear(now, within, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const int e = boxes_->order()[static_cast<std::size_t>(i)];
        if ((now.transpose().array() >= low_.row(e).array()).all() &&
            (now.transpose().array() <= high_.row(e).array()).all())
          take(e);
      }
    });
  if (best.element < 0) return {};
  best.before = before(best.element, best.barycentric);
  return best;
}

}  // namespace falciform
