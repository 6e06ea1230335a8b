#include "Logic/Geometry/Curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

Surface asCloud(Surface surface) {
  surface.normals = vertexNormals(surface);
  surface.triangles.resize(0, 3);
  return surface;
}

/// The grid of 40 mm with its middle at the origin, lifted to z(x, y).
template <class Height>
Surface lifted(const Height& height, int cells = 40) {
  Surface s = test::grid(40, cells);
  for (Index i = 0; i < s.size(); ++i) {
    s.points(i, 0) -= 20;
    s.points(i, 1) -= 20;
    s.points(i, 2) = height(s.points(i, 0), s.points(i, 1));
  }
  return s;
}

/// Not within `marginMm` of the border of the grid above, where the points around lie to one side.
bool inner(const Surface& s, Index i, double marginMm) {
  return std::max(std::abs(s.points(i, 0)), std::abs(s.points(i, 1))) < 20 - marginMm;
}

/// The grid bent about the y axis to a half tube of radius r, outwards away from the axis.
Surface tube(double r) {
  Surface s = test::grid(std::numbers::pi * r, 80);
  for (Index i = 0; i < s.size(); ++i) {
    const double angle = s.points(i, 0) / r;
    s.points(i, 0) = -r * std::cos(angle);
    s.points(i, 2) = r * std::sin(angle);
  }
  return s;
}

CurvatureSettings byRadius(double mm) {
  CurvatureSettings settings;
  settings.radiusMm = mm;
  return settings;
}

double median(VectorXd values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

TEST(Curvature, OfASphereIsOneOverItsRadiusWithin2Percent) {
  for (const double r : {5.0, 50.0, 200.0}) {
    const Surface s = test::sphere(r, 4);  // edges of 0.07 r
    for (const Surface& side : {s, asCloud(s)})
      for (const CurvatureSettings& settings : {CurvatureSettings(), byRadius(0.2 * r)}) {
        const VectorXd mean = meanCurvature(side, settings);
        EXPECT_LT((mean.array() * r - 1).abs().maxCoeff(), 0.02) << r;
      }
  }
}

TEST(Curvature, IsNegativeWhereOutwardsIsTheHollowSide) {
  Surface s = test::sphere(20, 4);
  s.triangles.col(1).swap(s.triangles.col(2));
  EXPECT_LT((meanCurvature(s).array() * -20 - 1).abs().maxCoeff(), 0.02);
}

TEST(Curvature, OfACylinderIsOneOverTwiceItsRadiusAndItsDirectionsLieAlongAndAcross) {
  const Surface s = tube(10);
  const Curvatures c = principalCurvatures(s);
  int tested = 0;
  for (Index i = 0; i < s.size(); ++i) {
    if (s.points(i, 2) < 2 || s.points(i, 1) < 2 || s.points(i, 1) > 29) continue;  // mm: off the border
    ++tested;
    EXPECT_NEAR(c.mean[i] * 20, 1, 0.02);
    EXPECT_NEAR(c.k1[i] * 10, 1, 0.02);
    EXPECT_NEAR(c.k2[i] * 10, 0, 0.02);
    EXPECT_NEAR(std::abs(c.direction2(i, 1)), 1, 1e-3);  // 2.5 deg off the axis
    EXPECT_NEAR(c.direction1.row(i).dot(c.direction2.row(i)), 0, 1e-12);
    EXPECT_NEAR(c.direction1.row(i).norm(), 1, 1e-12);
  }
  EXPECT_GT(tested, 4000);
}

TEST(Curvature, OfASaddleIsNoneInItsMiddleAndAsTheFormulaOfAGraphSaysBesideIt) {
  const double a = 0.02;  // 1/mm: principal curvatures of 25 mm in the middle, slopes up to 45 deg at the rim
  const Surface s = lifted([&](double x, double y) { return 0.5 * 2 * a * (x * x - y * y); });
  const VectorXd mean = meanCurvature(s);
  for (Index i = 0; i < s.size(); ++i) {
    if (!inner(s, i, 3)) continue;
    const double x = s.points(i, 0), y = s.points(i, 1), zx = 2 * a * x, zy = -2 * a * y;
    const double exact =
        -((1 + zy * zy) * 2 * a - (1 + zx * zx) * 2 * a) / (2 * std::pow(1 + zx * zx + zy * zy, 1.5));
    EXPECT_NEAR(mean[i], exact, 0.02 * 2 * a);  // 2 % of the principal curvature
    if (std::hypot(x, y) < 1e-9) {
      EXPECT_NEAR(mean[i], 0, 1e-12);
    }
  }
}

TEST(Curvature, OfATorusHasBothPrincipalCurvatures) {
  const double ring = 30, tubeRadius = 10;
  const Surface s = test::torus(ring, tubeRadius, 240, 96);  // edges of 0.7 mm
  for (const Surface& side : {s, asCloud(s)}) {
    const Curvatures c = principalCurvatures(side);
    EXPECT_LT((meanCurvature(side) - c.mean).cwiseAbs().maxCoeff(), 1e-12);
    for (Index i = 0; i < s.size(); ++i) {
      const double aside = std::hypot(s.points(i, 0), s.points(i, 1));
      const double round = (aside - ring) / (tubeRadius * aside);  // cos(angle) / distance from the axis
      EXPECT_NEAR(c.k1[i], 1 / tubeRadius, 0.02 / tubeRadius);
      EXPECT_NEAR(c.k2[i], round, 0.02 / tubeRadius);
      EXPECT_NEAR(c.mean[i], 0.5 * (c.k1[i] + c.k2[i]), 1e-14);
      if (i > 200) break;  // of 23,040, all alike by symmetry but for the angle on the tube
    }
  }
}

TEST(Curvature, OfAQuadricIsExactHoweverItIsSampled) {
  // Any sampling of a paraboloid lies on the fitted quadric at its top, where the frame is its own.
  Surface s = lifted([](double x, double y) { return -0.03 * x * x + 0.01 * x * y - 0.005 * y * y; }, 20);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  Index top = -1;
  for (Index i = 0; i < s.size(); ++i) {
    if (s.points.row(i).norm() < 1e-9) {
      top = i;
      continue;
    }
    const double x = s.points(i, 0) += jitter(random), y = s.points(i, 1) += jitter(random);
    s.points(i, 2) = -0.03 * x * x + 0.01 * x * y - 0.005 * y * y;
  }
  ASSERT_GE(top, 0);
  s = asCloud(s);
  s.normals.row(top) << 0, 0, 1;
  const Curvatures c = principalCurvatures(s);
  EXPECT_NEAR(c.mean[top], 0.035, 1e-12);
  EXPECT_NEAR(c.k1[top] * c.k2[top], 0.06 * 0.01 - 0.01 * 0.01, 1e-12);
}

TEST(Curvature, TheThesisFitIsRightInTheMiddleOnASphereAndOffWhereTheNormalIs) {
  const Surface s = test::sphere(50, 4);
  // 4 points for 3 unknowns: right in the middle, but where the four lie near one conic through the place the
  // system is singular, and the value anything.
  EXPECT_NEAR(median(meanCurvature(s, thesisCurvature())) * 50, 1, 0.02);
  // Normals that lean by 3 deg, as those of coarse facets do: linear terms take it up, the thesis's fit does
  // not.
  Surface leaning = asCloud(s);
  std::mt19937 random(6);
  std::normal_distribution<double> lean(0, 0.05);
  for (Index i = 0; i < leaning.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) leaning.normals(i, axis) += lean(random);
    leaning.normals.row(i).normalize();
  }
  const VectorXd ours = meanCurvature(leaning), thesis = meanCurvature(leaning, thesisCurvature());
  EXPECT_LT((ours.array() * 50 - 1).abs().maxCoeff(), 0.03);
  EXPECT_GT(median((thesis.array() * 50 - 1).abs()), 0.1);
}

TEST(Curvature, DoesNotChangeWhenTheSurfaceMoves) {
  const Surface s = test::lumpyBody(4);
  const Surface moved = transformed(s, test::randomMotion(12), "scanner");
  for (const CurvatureSettings& settings : {CurvatureSettings(), byRadius(8)}) {
    const VectorXd a = meanCurvature(s, settings), b = meanCurvature(moved, settings);
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-10);  // 1/mm: rounding of 100 mm over (1 mm)^2
  }
}

TEST(Curvature, IsTheSameOnAnyNumberOfThreads) {
  const Surface s = test::lumpyBody(4);
  for (const CurvatureSettings& settings : {CurvatureSettings(), byRadius(6), thesisCurvature()}) {
    setThreads(1);
    const VectorXd one = meanCurvature(s, settings), oneCloud = meanCurvature(asCloud(s), settings);
    setThreads(4);
    EXPECT_EQ(one, meanCurvature(s, settings));
    EXPECT_EQ(oneCloud, meanCurvature(asCloud(s), settings));
    setThreads(0);
  }
}

TEST(Curvature, IsTheSameForAMeshStoredTriangleByTriangle) {
  const Surface s = test::sphere(30, 3);
  Surface loose;
  loose.points.resize(3 * s.triangles.rows(), 3);
  loose.triangles.resize(s.triangles.rows(), 3);
  for (Index t = 0; t < s.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      loose.points.row(3 * t + k) = s.points.row(s.triangles(t, k));
      loose.triangles(t, k) = static_cast<int>(3 * t + k);
    }
  const VectorXd joined = meanCurvature(s), apart = meanCurvature(loose);
  for (Index t = 0; t < s.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(apart[3 * t + k], joined[s.triangles(t, k)], 1e-12);
}

TEST(Curvature, DoesNotReachThroughAThinLobe) {
  // Two sheets 1 mm apart, back to back, one of them bent: within 4 mm of each other, but not joined.
  Surface top = lifted([](double x, double) { return -0.02 * x * x; });
  Surface both = top;
  const Index n = top.size(), m = top.triangles.rows();
  both.points.conservativeResize(2 * n, 3);
  both.points.bottomRows(n) = top.points;
  both.points.bottomRows(n).col(2).setConstant(-10);
  both.triangles.conservativeResize(2 * m, 3);
  for (Index t = 0; t < m; ++t)
    both.triangles.row(m + t) << static_cast<int>(n) + top.triangles(t, 0),
        static_cast<int>(n) + top.triangles(t, 2), static_cast<int>(n) + top.triangles(t, 1);
  for (const Surface& s : {both, asCloud(both)}) {
    const VectorXd alone = meanCurvature(s.triangles.rows() > 0 ? top : asCloud(top), byRadius(4));
    const VectorXd paired = meanCurvature(s, byRadius(4));
    for (Index i = 0; i < n; ++i) EXPECT_NEAR(paired[i], alone[i], 1e-12);
  }
}

TEST(Curvature, IsNotANumberWhereNoQuadricCanBeFitted) {
  Surface s = test::box({1, 1, 1});  // its own piece, fit or not
  Surface one;
  one.points.resize(3, 3);
  one.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  one.triangles.resize(1, 3);
  one.triangles << 0, 1, 2;
  EXPECT_TRUE(meanCurvature(one).array().isNaN().all());  // three points
  one.points.row(2) << 2, 0, 0;
  EXPECT_TRUE(meanCurvature(one).array().isNaN().all());  // no normal
  s.points.conservativeResize(9, 3);
  s.points.row(8) << 5, 5, 5;
  EXPECT_TRUE(std::isnan(meanCurvature(s)[8]));  // of no triangle
  EXPECT_TRUE(std::isnan(principalCurvatures(s).direction1(8, 0)));

  Surface line;  // 30 points in line, all told to face up
  line.points = Points::Zero(30, 3);
  line.points.col(0) = VectorXd::LinSpaced(30, 0, 29);
  line.normals = Points::Zero(30, 3);
  line.normals.col(2).setOnes();
  EXPECT_TRUE(meanCurvature(line).array().isNaN().all());
  line.points.setZero();  // and all in one place
  EXPECT_TRUE(meanCurvature(line).array().isNaN().all());
}

TEST(Curvature, IsLeftOutAtABorderWhereAskedTo) {
  const Surface s = lifted([](double x, double y) { return -0.01 * (x * x + y * y); });
  CurvatureSettings settings = byRadius(5);
  settings.largestLean = 0.25;
  const VectorXd everywhere = meanCurvature(s, byRadius(5)), kept = meanCurvature(s, settings);
  for (Index i = 0; i < s.size(); ++i) {
    EXPECT_FALSE(std::isnan(everywhere[i]));
    if (!inner(s, i, 1)) {
      EXPECT_TRUE(std::isnan(kept[i]));
    }
    if (inner(s, i, 5)) {
      EXPECT_EQ(kept[i], everywhere[i]);
    }
  }
}

TEST(Curvature, RefusesACloudThatHasNoOutside) {
  Surface cloud;
  cloud.points = Points::Random(30, 3);
  EXPECT_THROW((void)meanCurvature(cloud), InputError);
  CurvatureSettings settings;
  settings.radiusMm = -1;
  EXPECT_THROW((void)meanCurvature(test::sphere(5, 2), settings), InputError);
}

}  // namespace
}  // namespace falciform
