#include "Logic/Geometry/RbfSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/RbfKernel.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

constexpr double kNoiseMm = 0.5;

/// What a smoothed surface is compared with: closest place on the true body, its normal and mean curvature.
struct Truth {
  Vector3d place, normal;
  double curvature;
};

struct Sphere {
  double radius;
  [[nodiscard]] Truth at(const Vector3d& p) const {
    return {radius * p.normalized(), p.normalized(), 1 / radius};
  }
  [[nodiscard]] Vector3d draw(Draws& draws) const { return radius * draws.direction(); }
};

struct Torus {
  double ring, tube;
  [[nodiscard]] Truth at(const Vector3d& p) const {
    const Vector3d middle = ring * Vector3d(p.x(), p.y(), 0).normalized(), n = (p - middle).normalized();
    const double away = Vector3d((middle + tube * n).x(), (middle + tube * n).y(), 0).norm();
    return {middle + tube * n, n, (1 / tube + (away - ring) / tube / away) / 2};
  }
  [[nodiscard]] Vector3d draw(Draws& draws) const {
    for (;;) {
      const double u = draws.uniform(0, 2 * std::numbers::pi), v = draws.uniform(0, 2 * std::numbers::pi);
      const double away = ring + tube * std::cos(v);
      if (draws.uniform() * (ring + tube) < away)  // evenly by area
        return {away * std::cos(u), away * std::sin(u), tube * std::sin(v)};
    }
  }
};

/// Points on the body with noise along the normal, and normals that are 20 degrees wrong.
template <class Body>
Surface noisyCloud(const Body& body, Index count, std::uint64_t seed) {
  Draws draws(seed);
  Surface cloud;
  cloud.points.resize(count, 3);
  cloud.normals.resize(count, 3);
  for (Index i = 0; i < count; ++i) {
    const Truth truth = body.at(body.draw(draws));
    cloud.points.row(i) = truth.place + kNoiseMm * draws.normal() * truth.normal;
    cloud.normals.row(i) = (truth.normal + 0.25 * draws.normal3()).normalized();
  }
  return cloud;
}

struct Errors {
  double placeMm = 0, normalDeg = 0, largestNormalDeg = 0, curvature = 0;  ///< RMS; curvature over RMS truth
};

template <class Body>
Errors errorsOf(const Surface& surface, const Body& body) {
  Errors e;
  double truth2 = 0;
  const VectorXd& curvature = surface.arrays.at(kMeanCurvature);
  for (Index i = 0; i < surface.size(); ++i) {
    const Vector3d p = surface.points.row(i), n = surface.normals.row(i);
    const Truth truth = body.at(p);
    const double angle = std::acos(std::min(1.0, n.dot(truth.normal))) * 180 / std::numbers::pi;
    e.placeMm += (p - truth.place).squaredNorm();
    e.normalDeg += angle * angle;
    e.largestNormalDeg = std::max(e.largestNormalDeg, angle);
    e.curvature += std::pow(curvature[i] - truth.curvature, 2);
    truth2 += truth.curvature * truth.curvature;
  }
  const auto n = static_cast<double>(surface.size());
  return {std::sqrt(e.placeMm / n), std::sqrt(e.normalDeg / n), e.largestNormalDeg,
          std::sqrt(e.curvature / truth2)};
}

TEST(RbfKernel, DerivativesAreThoseOfTheValue) {
  const double h = 1e-5;
  for (const double share : {0.0, RbfKernel::kEvenShare})
    for (double t = 0.1; t < 8.9; t += 0.37) {
      const RbfKernel k{share};
      const auto by = [&](auto f) { return (f(std::sqrt(t + h)) - f(std::sqrt(t - h))) / (2 * h); };
      // Central differences with h = 1e-5 of a function of order 1: good to 1e-9.
      EXPECT_NEAR(by([&](double r) { return k.value(r); }), k.first(std::sqrt(t)), 1e-8);
      EXPECT_NEAR(by([&](double r) { return k.first(r); }), k.second(std::sqrt(t)), 1e-8);
      EXPECT_NEAR(by([&](double r) { return k.second(r); }), k.thirdTimesR(std::sqrt(t)) / std::sqrt(t),
                  1e-8);
    }
}

TEST(RbfKernel, WithEvenShareEqualFunctionsAddUpToAConstant) {
  for (const double share : {0.0, RbfKernel::kEvenShare}) {
    Draws draws(3);
    double low = 1e9, high = 0;
    for (int n = 0; n < 200; ++n) {
      const Vector3d p(draws.uniform(), draws.uniform(), draws.uniform());
      double sum = 0;
      for (int z = -3; z <= 4; ++z)
        for (int y = -3; y <= 4; ++y)
          for (int x = -3; x <= 4; ++x)
            if (const double r = (p - Vector3d(x, y, z)).norm(); r < RbfKernel::kReach)
              sum += RbfKernel{share}.value(r);
      low = std::min(low, sum);
      high = std::max(high, sum);
    }
    if (share > 0)
      EXPECT_LT((high - low) / low, 5e-5);  // the higher frequencies' part: 24 of 1e-6
    else
      EXPECT_GT((high - low) / low, 1e-3);  // and this is why
  }
}

TEST(RbfSurface, NoisySphereGetsNormalsWithinADegreeAndCurvatureWithinTwoPercent) {
  const Sphere body{60};
  const RbfSurfaceResult result = smoothByRbf(noisyCloud(body, 20000, 1), {.edgeLengthMm = 3});
  const Errors e = errorsOf(result.surface, body);
  EXPECT_LT(e.placeMm, 0.05);
  EXPECT_LT(e.largestNormalDeg, 1);
  EXPECT_LT(e.curvature, 0.02);
  EXPECT_NEAR(result.fit.noiseMm, kNoiseMm, 0.02);  // found from the points: 2,000 samples, 2 %
  EXPECT_TRUE(inspectTopology(result.surface).closedManifold());
}

TEST(RbfSurface, NoisyTorusGetsNormalsWithinADegreeAndCurvatureWithinTwoPercent) {
  const Torus body{80, 50};
  const RbfSurfaceResult result = smoothByRbf(noisyCloud(body, 60000, 2), {.edgeLengthMm = 4});
  const Errors e = errorsOf(result.surface, body);
  EXPECT_LT(e.placeMm, 0.06);
  EXPECT_LT(e.largestNormalDeg, 1);
  EXPECT_LT(e.curvature, 0.02);
  const TopologyReport topology = inspectTopology(result.surface);
  EXPECT_TRUE(topology.closedManifold());
  EXPECT_EQ(topology.eulerCharacteristic, 0);  // still a torus
}

TEST(RbfSurface, EdgesHaveTheLengthAskedFor) {
  const RbfSurfaceResult result = smoothByRbf(test::sphere(50, 5), {.edgeLengthMm = 4});
  EXPECT_NEAR(meanEdgeLength(result.surface), 4, 0.4);  // remeshing keeps edges between 4/5 and 4/3
}

TEST(RbfSurface, AnExactLumpyBodyIsFollowed) {
  const Surface body = test::lumpyBody();
  const RbfSurfaceResult result = smoothByRbf(body, {});
  EXPECT_LT(result.rmsMm, 0.1);  // its vertices are some 2 mm apart
  EXPECT_NEAR(signedVolume(result.surface) / signedVolume(body), 1, 2e-3);
}

/// A shallow bowl of 80 mm, seen from above, without the points within `radius` of each centre.
Surface bowlWithHoles(const std::vector<std::pair<Vector3d, double>>& holes) {
  Surface s = test::grid(80, 60);
  std::vector<int> keep;
  for (Index i = 0; i < s.size(); ++i) {
    const double x = s.points(i, 0) - 40, y = s.points(i, 1) - 40;
    s.points(i, 2) = -(x * x + y * y) / 200;
    bool in = true;
    for (const auto& [c, r] : holes)
      in = in && std::hypot(s.points(i, 0) - c.x(), s.points(i, 1) - c.y()) > r;
    if (in) keep.push_back(static_cast<int>(i));
  }
  return subset(s, keep);
}

TEST(RbfSurface, SmallHolesAreClosedWideOnesStayAndTheBorderIsNotPassed) {
  const Surface bowl = bowlWithHoles({{{25, 25, 0}, 4}, {{52, 50, 0}, 14}});
  const Surface filled = smoothByRbf(bowl, {.edgeLengthMm = 1.5, .fillHolesMm = 12}).surface;
  double inSmall = 1e9, inWide = 1e9, beyond = 0;
  for (Index i = 0; i < filled.size(); ++i) {
    const Vector3d p = filled.points.row(i);
    inSmall = std::min(inSmall, std::hypot(p.x() - 25, p.y() - 25));
    inWide = std::min(inWide, std::hypot(p.x() - 52, p.y() - 50));
    beyond = std::max({beyond, -p.x(), -p.y(), p.x() - 80, p.y() - 80});
    if (p.head<2>().minCoeff() < 0 || p.head<2>().maxCoeff() > 80) continue;
    const double x = p.x() - 40, y = p.y() - 40;
    EXPECT_NEAR(p.z(), -(x * x + y * y) / 200, 0.1);  // also where the hole was
  }
  EXPECT_LT(inSmall, 1.5);  // an edge length
  EXPECT_GT(inWide, 10);    // 14 less twice the points' spacing of 1.3 mm
  EXPECT_LT(beyond, 3.0);   // twice the spacing
  const Surface left = smoothByRbf(bowl, {.edgeLengthMm = 1.5, .fillHolesMm = 0}).surface;
  inSmall = 1e9;
  for (Index i = 0; i < left.size(); ++i)
    inSmall = std::min(inSmall, std::hypot(left.points(i, 0) - 25, left.points(i, 1) - 25));
  EXPECT_GT(inSmall, 1);
}

TEST(RbfSurface, PatchesColoursAndSegmentsAreThoseOfTheNearestPoint) {
  Surface body = test::sphere(40, 4);
  body.patchNames[5] = "dome";
  body.arrays["couinaud_segment"].resize(body.size());
  body.colours.resize(body.size(), 3);
  for (Index i = 0; i < body.size(); ++i) {
    const bool up = body.points(i, 2) > 0;
    body.patch.push_back(up ? 5 : 0);
    body.arrays["couinaud_segment"][i] = up ? 8 : 6;
    body.colours.row(i).setConstant(up ? 200 : 10);
  }
  const Surface smooth = smoothByRbf(body, {}).surface;
  ASSERT_EQ(std::ssize(smooth.patch), smooth.size());
  for (Index i = 0; i < smooth.size(); ++i) {
    if (std::abs(smooth.points(i, 2)) < 3) continue;  // an edge length from the limit
    const bool up = smooth.points(i, 2) > 0;
    EXPECT_EQ(smooth.patchAt(i), up ? 5 : 0);
    EXPECT_EQ(smooth.arrays.at("couinaud_segment")[i], up ? 8 : 6);
    EXPECT_EQ(smooth.colours(i, 1), up ? 200 : 10);
  }
  EXPECT_EQ(smooth.patchNames.at(5), "dome");
}

TEST(RbfSurface, IsTheSameForAnyNumberOfThreads) {
  const Surface cloud = noisyCloud(Torus{60, 25}, 6000, 5);
  setThreads(1);
  const Surface one = smoothByRbf(cloud, {}).surface;
  setThreads(3);
  const Surface three = smoothByRbf(cloud, {}).surface;
  setThreads(0);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.triangles, three.triangles);
}

TEST(RbfSurface, MovesWithItsPoints) {
  const Surface body = test::lumpyBody(4);
  const Isometry3d motion = test::randomMotion(11);
  const Surface here = smoothByRbf(body, {}).surface,
                there = smoothByRbf(transformed(body, motion, "scanner"), {}).surface;
  EXPECT_EQ(there.frame, "scanner");
  // The lattice lies otherwise in the body: alike to what functions some 9 mm apart leave over.
  EXPECT_NEAR(signedVolume(there) / signedVolume(here), 1, 2e-3);
  EXPECT_NEAR(area(there) / area(here), 1, 5e-3);
}

TEST(RbfSurface, SaysWhatItCannotUse) {
  Surface cloud = test::sphere(40, 3);
  cloud.triangles.resize(0, 3);
  EXPECT_THROW((void)smoothByRbf(cloud, {}), InputError);  // no outside
  EXPECT_THROW((void)smoothByRbf(test::box({10, 10, 10}), {}), InputError);
  Surface one = test::sphere(40, 3);
  one.points.rowwise() = one.points.row(0).eval();
  EXPECT_THROW((void)smoothByRbf(one, {}), InputError);  // all in one place
  EXPECT_THROW((void)smoothByRbf(test::sphere(40, 3), {.edgeLengthMm = 0.001}), InputError);
}

}  // namespace
}  // namespace falciform
