#include "Logic/Biomechanics/MeshPlaces.h"

#include <algorithm>

#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/BoxTree.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 512;
/// A query on a face shared by two elements may lie outside both by rounding: barycentric, so a share of the
/// element's height.
constexpr double kInside = -1e-10;

struct Corners4 {
  Points low, high;
};

Corners4 boxesOf(const TetrahedralMesh& mesh) {
  Corners4 boxes{Points(mesh.size(), 3), Points(mesh.size(), 3)};
  for (Index e = 0; e < mesh.size(); ++e) {
    const Eigen::Matrix<double, 4, 3> corners =
        mesh.points(mesh.elements.row(e).head(4).transpose().eval(), Eigen::all);
    const Eigen::RowVector3d low = corners.colwise().minCoeff(), high = corners.colwise().maxCoeff();
    const double slack = 1e-9 * (high - low).maxCoeff();  // for kInside
    boxes.low.row(e) = low.array() - slack;
    boxes.high.row(e) = high.array() + slack;
  }
  return boxes;
}

}  // namespace

struct MeshLocator::Tree {
  TetrahedralMesh mesh;
  std::vector<Eigen::Matrix<double, 4, 3>> gradients;  ///< by element
  std::vector<Vector3d> middle;                        ///< where all four coordinates are 1/4
  BoxTree boxes;
  BoundaryFaces boundary;
  TriangleTree surface;

  explicit Tree(const TetrahedralMesh& m) : Tree(m, boxesOf(m)) {}
  Tree(const TetrahedralMesh& m, const Corners4& b)
      : mesh(m),
        boxes(b.low, b.high),
        boundary(boundaryFaces(m)),
        surface(boundarySurface(m, boundary).surface) {
    gradients.resize(static_cast<std::size_t>(mesh.size()));
    middle.resize(gradients.size());
    for (Index e = 0; e < mesh.size(); ++e) {
      const auto i = static_cast<std::size_t>(e);
      gradients[i] = barycentricGradients(mesh, e);
      middle[i] = mesh.points(mesh.elements.row(e).head(4).transpose().eval(), Eigen::all)
                      .colwise()
                      .mean()
                      .transpose();
    }
  }

  [[nodiscard]] Eigen::Vector4d barycentric(int element, const Vector3d& query) const {
    const auto i = static_cast<std::size_t>(element);
    return (gradients[i] * (query - middle[i])).array() + 0.25;
  }
};

MeshLocator::MeshLocator(const TetrahedralMesh& mesh) {
  checkMesh(mesh, "the mesh");
  tree_ = std::make_shared<const Tree>(mesh);
}

const TetrahedralMesh& MeshLocator::mesh() const { return tree_->mesh; }

const Eigen::Matrix<double, 4, 3>& MeshLocator::gradients(int element) const {
  return tree_->gradients[static_cast<std::size_t>(element)];
}

MeshLocator::Place MeshLocator::find(const Vector3d& query) const {
  Place best;
  double deepest = kInside;
  const double within = 0;  // of the boxes: those that hold the query
  tree_->boxes.visitNear(query, within, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const int e = tree_->boxes.order()[static_cast<std::size_t>(i)];
      const Eigen::Vector4d place = tree_->barycentric(e, query);
      const double depth = place.minCoeff();
      if (depth < deepest || (depth == deepest && best.element >= 0 && e > best.element)) continue;
      deepest = depth;
      best.element = e;
      best.barycentric = place;
    }
  });
  if (best.element >= 0) return best;
  const ClosestPlace nearest = tree_->surface.closest(query);
  best.element = tree_->boundary.elements[static_cast<std::size_t>(nearest.triangle)];
  best.barycentric = tree_->barycentric(best.element, nearest.point);
  best.outsideMm = nearest.distance;
  return best;
}

MeshPlaces::MeshPlaces(const TetrahedralMesh& mesh, const Points& points)
    : MeshPlaces(MeshLocator(mesh), points) {}

MeshPlaces::MeshPlaces(const MeshLocator& locator, const Points& points) {
  if (!points.allFinite())
    throw InputError("points to find in a mesh have coordinates that are not finite numbers; remove them");
  const TetrahedralMesh& mesh = locator.mesh();
  const auto perElement = static_cast<int>(mesh.elements.cols());
  meshNodes_ = mesh.nodes();
  elements_.resize(static_cast<std::size_t>(points.rows()));
  nodes_.resize(points.rows(), perElement);
  weights_.resize(points.rows(), perElement);
  outsideMm_.resize(points.rows());
  forEachChunk(elements_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      const Vector3d query = points.row(i).transpose();
      const MeshLocator::Place place = locator.find(query);
      elements_[static_cast<std::size_t>(i)] = place.element;
      nodes_.row(i) = mesh.elements.row(place.element);
      weights_.row(i) = shapeValues(place.barycentric, perElement).transpose();
      outsideMm_[i] = place.outsideMm;
      if (place.outsideMm == 0) continue;
      const auto& gradients = locator.gradients(place.element);
      Vector3d nearest = Vector3d::Zero();
      for (Index k = 0; k < 4; ++k)
        nearest += place.barycentric[k] * mesh.points.row(nodes_(i, k)).transpose();
      weights_.row(i) +=
          (shapeGradients(place.barycentric, gradients, perElement) * (query - nearest)).transpose();
    }
  });
}

MeshPlaces::Weights MeshPlaces::interpolate(const Eigen::Ref<const Weights>& nodalField) const {
  if (nodalField.rows() != meshNodes_)
    throw InputError("the field has " + std::to_string(nodalField.rows()) + " rows for a mesh of " +
                     std::to_string(meshNodes_) + " nodes; give one row a node");
  Weights values(size(), nodalField.cols());
  forEachChunk(elements_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      values.row(i).setZero();
      for (Index k = 0; k < nodes_.cols(); ++k)
        values.row(i) += weights_(i, k) * nodalField.row(nodes_(i, k));
    }
  });
  return values;
}

}  // namespace falciform
