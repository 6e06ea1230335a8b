#include "Logic/Biomechanics/MeshPlaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/QuadraticMesh.h"
#include "Logic/Biomechanics/ReferenceTetrahedron.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TetrahedralMesh lumpyMesh(ElementOrder order) {
  MeshSettings settings;
  settings.edgeLengthMm = 20;
  settings.order = order;
  return meshLiver(test::lumpyBody(3), {}, settings).mesh;
}

/// Uniform in the mesh's box grown by `marginMm`.
Points scattered(const TetrahedralMesh& mesh, int count, double marginMm, unsigned seed) {
  const auto box = boundingBox(mesh.points);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Points points(count, 3);
  for (Index i = 0; i < count; ++i)
    for (Index k = 0; k < 3; ++k)
      points(i, k) = box(0, k) - marginMm + unit(random) * (box(1, k) - box(0, k) + 2 * marginMm);
  return points;
}

double quadraticField(const Eigen::RowVector3d& p) {
  return 3 - 0.2 * p.x() + 0.01 * p.x() * p.y() - 0.003 * p.z() * p.z() + 0.004 * p.y() * p.z();
}
double linearField(const Eigen::RowVector3d& p) { return 3 - 0.2 * p.x() + 0.7 * p.y() - 0.4 * p.z(); }

template <class Field>
VectorXd sampled(const Points& points, Field&& field) {
  VectorXd values(points.rows());
  for (Index i = 0; i < points.rows(); ++i) values[i] = field(points.row(i));
  return values;
}

TEST(MeshPlaces, InterpolateQuadraticFieldsExactlyInsideQuadraticElements) {
  const TetrahedralMesh mesh = lumpyMesh(ElementOrder::Quadratic);
  const Points points = scattered(mesh, 3000, 0, 1);
  const MeshPlaces places(mesh, points);
  const VectorXd values = places.interpolate(sampled(mesh.points, quadraticField));
  Index inside = 0;
  for (Index i = 0; i < points.rows(); ++i) {
    if (places.outsideMm()[i] > 0) continue;
    ++inside;
    // Values of up to 1e2, rounding of ten products.
    EXPECT_NEAR(values[i], quadraticField(points.row(i)), 1e-9);
  }
  EXPECT_GT(inside, 1000);
}

TEST(MeshPlaces, ContinueLinearFieldsExactlyOutside) {
  for (const ElementOrder order : {ElementOrder::Linear, ElementOrder::Quadratic}) {
    const TetrahedralMesh mesh = lumpyMesh(order);
    const Points points = scattered(mesh, 2000, 30, 2);
    const MeshPlaces places(mesh, points);
    const VectorXd values = places.interpolate(sampled(mesh.points, linearField));
    EXPECT_GT((places.outsideMm().array() > 1).count(), 500);
    for (Index i = 0; i < points.rows(); ++i)
      // Weights grow with the distance by the height of the element, hence above plain rounding.
      EXPECT_NEAR(values[i], linearField(points.row(i)), 1e-7);
  }
}

TEST(MeshPlaces, HaveWeightsThatSumToOne) {
  for (const ElementOrder order : {ElementOrder::Linear, ElementOrder::Quadratic}) {
    const TetrahedralMesh mesh = lumpyMesh(order);
    const MeshPlaces places(mesh, scattered(mesh, 2000, 20, 3));
    EXPECT_EQ(places.weights().cols(), order == ElementOrder::Linear ? 4 : 10);
    for (Index i = 0; i < places.size(); ++i) EXPECT_NEAR(places.weights().row(i).sum(), 1, 1e-9);
  }
}

TEST(MeshPlaces, FindTheElementThatBruteForceFinds) {
  const TetrahedralMesh mesh = lumpyMesh(ElementOrder::Linear);
  const Points points = scattered(mesh, 1500, 10, 4);
  const MeshPlaces places(mesh, points);
  for (Index i = 0; i < points.rows(); ++i) {
    double deepest = -1e300;
    int best = -1;
    for (int e = 0; e < static_cast<int>(mesh.size()); ++e) {
      const Eigen::Matrix<double, 4, 3> gradients = barycentricGradients(mesh, e);
      const Vector3d from = (points.row(i) - mesh.points.row(mesh.elements(e, 0))).transpose();
      const double depth = (gradients * from + Eigen::Vector4d::Unit(0)).minCoeff();
      if (depth > deepest) {
        deepest = depth;
        best = e;
      }
    }
    EXPECT_EQ(deepest<0, places.outsideMm()[i]> 0) << i;
    if (deepest > 1e-9) {
      EXPECT_EQ(places.elements()[static_cast<std::size_t>(i)], best);
    }
  }
}

TEST(MeshPlaces, PutNodesOnThemselves) {
  const TetrahedralMesh mesh = lumpyMesh(ElementOrder::Quadratic);
  const MeshPlaces places(mesh, mesh.points);
  EXPECT_LT(places.outsideMm().maxCoeff(), 1e-9);  // mm: nodes of the boundary, by rounding
  const Points moved = places.interpolate(mesh.points);
  EXPECT_LT((moved - mesh.points).cwiseAbs().maxCoeff(), 1e-9);  // mm
}

TEST(MeshPlaces, SayHowFarOutsideAPointLies) {
  TetrahedralMesh mesh;
  mesh.points.resize(4, 3);
  mesh.points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
  mesh.elements.resize(1, 4);
  mesh.elements << 0, 1, 2, 3;
  Points points(3, 3);
  points << 2, 2, -3, 1, 1, 1, -4, -3, 2;
  const MeshPlaces places(mesh, points);
  EXPECT_NEAR(places.outsideMm()[0], 3, 1e-12);  // mm, rounding
  EXPECT_EQ(places.outsideMm()[1], 0);
  EXPECT_NEAR(places.outsideMm()[2], 5, 1e-12);  // to the edge x = y = 0
  EXPECT_EQ(places.elements(), (std::vector<int>{0, 0, 0}));
}

TEST(MeshPlaces, AreTheSameForAnyNumberOfThreads) {
  const TetrahedralMesh mesh = lumpyMesh(ElementOrder::Quadratic);
  const Points points = scattered(mesh, 5000, 20, 5);
  setThreads(1);
  const MeshPlaces one(mesh, points);
  setThreads(4);
  const MeshPlaces four(mesh, points);
  setThreads(0);
  EXPECT_TRUE(one.weights() == four.weights() && one.nodes() == four.nodes() &&
              one.outsideMm() == four.outsideMm());
}

TEST(MeshPlaces, RefuseFieldsOfAnotherMesh) {
  const TetrahedralMesh mesh = lumpyMesh(ElementOrder::Linear);
  const MeshPlaces places(mesh, mesh.points);
  EXPECT_THROW((void)places.interpolate(Points::Zero(mesh.nodes() + 1, 3)), InputError);
  Points bad = mesh.points;
  bad(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(MeshPlaces(mesh, bad), InputError);
}

}  // namespace
}  // namespace falciform
