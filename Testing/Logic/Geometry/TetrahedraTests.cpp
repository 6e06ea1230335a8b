#include "Logic/Geometry/Tetrahedra.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::box;
using test::sphere;

#ifndef FALCIFORM_WITH_TETGEN

TEST(Tetrahedra, SaysHowToGetTetGenWhereTheBuildIsWithoutIt) {
  try {
    (void)tetrahedralise(box({1, 1, 1}));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("FALCIFORM_WITH_TETGEN"));
  }
}

#else

std::vector<double> volumes(const TetrahedralMesh& mesh) {
  std::vector<double> result;
  for (Index t = 0; t < mesh.elements.rows(); ++t) {
    const auto corner = [&](int k) { return Vector3d(mesh.points.row(mesh.elements(t, k)).transpose()); };
    result.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(corner(3) - corner(0)) / 6);
  }
  return result;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

using Face = std::array<int, 3>;
Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

/// Faces of one tetrahedron only, and how often each face occurs.
std::map<Face, int> faces(const TetrahedralMesh& mesh) {
  std::map<Face, int> count;
  for (Index t = 0; t < mesh.elements.rows(); ++t)
    for (int left = 0; left < 4; ++left) {
      Face face{};
      for (int k = 0, n = 0; k < 4; ++k)
        if (k != left) face[static_cast<std::size_t>(n++)] = mesh.elements(t, k);
      ++count[sorted(face)];
    }
  return count;
}

std::string errorOf(const Surface& surface, double maxVolume = 0) {
  try {
    (void)tetrahedralise(surface, maxVolume);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Tetrahedra, FillTheSurfacesVolumeWithPositiveVolumes) {
  for (const Surface& surface :
       {box({30, 20, 10}), sphere(40, 3, {5, -7, 100}), test::torus(40, 15, 40, 20), test::lumpyBody(4)}) {
    const TetrahedralMesh mesh = tetrahedralise(surface);
    const std::vector<double> v = volumes(mesh);
    ASSERT_FALSE(v.empty());
    EXPECT_GT(*std::min_element(v.begin(), v.end()), 0.0);
    EXPECT_NEAR(sum(v), signedVolume(surface), 1e-9 * signedVolume(surface));  // rounding of sums only
  }
}

TEST(Tetrahedra, KeepTheBoundaryAsItIs) {
  const Surface surface = test::lumpyBody(4);
  const TetrahedralMesh mesh = tetrahedralise(surface, 500);
  ASSERT_GE(mesh.points.rows(), surface.size());
  EXPECT_TRUE(mesh.points.topRows(surface.size()) == surface.points);
  std::map<Face, int> wanted;
  for (Index t = 0; t < surface.triangles.rows(); ++t)
    ++wanted[sorted({surface.triangles(t, 0), surface.triangles(t, 1), surface.triangles(t, 2)})];
  std::map<Face, int> outer;
  for (const auto& [face, count] : faces(mesh)) {
    EXPECT_LE(count, 2);
    if (count == 1) outer[face] = 1;
  }
  EXPECT_EQ(outer, wanted);
}

TEST(Tetrahedra, AreRefinedByTheLargestVolume) {
  const Surface surface = sphere(40, 3);
  Index previous = 0;
  for (const double bound : {4000.0, 400.0, 40.0}) {
    const TetrahedralMesh mesh = tetrahedralise(surface, bound);
    const std::vector<double> v = volumes(mesh);
    // Where the boundary is kept, its triangles may forbid smaller ones: one in fifty may be larger.
    const auto larger = std::count_if(v.begin(), v.end(), [&](double x) { return x > bound * (1 + 1e-9); });
    EXPECT_LE(static_cast<double>(larger), 0.02 * static_cast<double>(v.size()));
    EXPECT_GT(mesh.elements.rows(), previous);
    EXPECT_NEAR(sum(v), signedVolume(surface), 1e-9 * signedVolume(surface));
    previous = mesh.elements.rows();
  }
}

TEST(Tetrahedra, AreTheSameEachTime) {
  const Surface surface = test::lumpyBody(3);
  const TetrahedralMesh a = tetrahedralise(surface, 1000), b = tetrahedralise(surface, 1000);
  EXPECT_TRUE(a.points == b.points && a.elements == b.elements);
}

TEST(Tetrahedra, RefuseOpenSurfaces) {
  EXPECT_THAT(errorOf(test::grid(10, 4)), testing::HasSubstr("closed surface"));
  Surface holed = sphere(20, 2);
  holed.triangles.conservativeResize(holed.triangles.rows() - 1, 3);
  EXPECT_THAT(errorOf(holed), testing::HasSubstr("closed surface"));
  EXPECT_THAT(errorOf(Surface{}), testing::HasSubstr("closed surface"));
}

TEST(Tetrahedra, RefuseSurfacesThatFaceInwards) {
  Surface inside = sphere(20, 2);
  inside.triangles.col(1).swap(inside.triangles.col(2));
  EXPECT_THAT(errorOf(inside), testing::HasSubstr("inwards"));
}

Surface both(const Surface& a, const Surface& b) {
  Surface all;
  all.points.resize(a.size() + b.size(), 3);
  all.points << a.points, b.points;
  all.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  all.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.size())).matrix();
  return all;
}

TEST(Tetrahedra, RefuseSurfacesThatCutThroughThemselvesWithoutPrinting) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const std::string error = errorOf(both(sphere(20, 2), sphere(20, 2, {13, 3, 1})));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(error, testing::HasSubstr("cuts through itself"));
}

TEST(Tetrahedra, FillPiecesSideBySideAndRefuseOneInsideAnother) {
  const Surface apart = both(sphere(20, 2), sphere(10, 2, {50, 0, 0}));
  EXPECT_NEAR(sum(volumes(tetrahedralise(apart))), signedVolume(apart), 1e-9 * signedVolume(apart));
  EXPECT_THAT(errorOf(both(sphere(20, 2), sphere(10, 2))), testing::HasSubstr("second surface inside"));
}

TEST(Tetrahedra, TakeInnerSurfacesAsFacesAndExtraPlacesAsNodes) {
  const Surface outer = sphere(40, 3), one = sphere(10, 2, {12, 0, 0}), two = sphere(6, 2, {-12, 3, 0});
  TetrahedraPlan plan{.maxVolumeMm3 = 600, .inner = {one, two}, .innerMaxVolumeMm3 = {20, 0}};
  plan.extra.resize(1, 3);
  plan.extra << 0, 0, 25;
  const TetrahedralMesh mesh = tetrahedralise(outer, plan);
  const Index first = outer.size(), second = first + one.size(), third = second + two.size();
  EXPECT_TRUE(mesh.points.middleRows(first, one.size()) == one.points);
  EXPECT_TRUE(mesh.points.middleRows(second, two.size()) == two.points);
  EXPECT_TRUE(mesh.points.row(third) == plan.extra.row(0));
  const std::vector<double> v = volumes(mesh);
  EXPECT_NEAR(sum(v), signedVolume(outer), 1e-9 * signedVolume(outer));
  // Each is inside the first ball as a whole or not at all: those inside fill it.
  double inside = 0;
  for (Index t = 0; t < mesh.size(); ++t) {
    const Vector3d centre =
        mesh.points(mesh.elements.row(t).transpose().eval(), Eigen::all).colwise().mean().transpose();
    if ((centre - Vector3d(12, 0, 0)).norm() > 9.4) continue;  // mm: facets of the ball lie 0.5 mm inside it
    inside += v[static_cast<std::size_t>(t)];
    EXPECT_LE(v[static_cast<std::size_t>(t)], 40);  // mm3: twice the bound, for those that its triangles hold
  }
  EXPECT_NEAR(inside, signedVolume(one), 1e-9 * inside);
}

TEST(Tetrahedra, RefuseVolumesThatAreNone) {
  EXPECT_THAT(errorOf(sphere(20, 1), -1), testing::HasSubstr("largest tetrahedron"));
  EXPECT_THAT(errorOf(sphere(20, 1), std::numeric_limits<double>::quiet_NaN()),
              testing::HasSubstr("largest tetrahedron"));
}

#endif

}  // namespace
}  // namespace falciform
