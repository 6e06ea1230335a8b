// ./run bench smoothing: radial basis functions beside VTK's windowed sinc on bodies of known shape with
// 0.5 mm of noise along the normal (Docs/Smoothing.md), and on a real liver where it is there.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/RbfSurface.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/VtkBridge/SurfaceFilters.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Support/RealData.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::bench {
namespace {

constexpr int kThreads = 2, kIterations = 30;
constexpr double kNoiseMm = 0.5, kPassBand = 0.03;  // the import step's

struct Body {
  const char* name;
  Surface exact;       // its vertices lie on the body
  VectorXd curvature;  // of the body at them
};

Body sphereBody() {
  Body body{"sphere of 60 mm, 40,962 points", test::sphere(60, 6), {}};
  body.curvature = VectorXd::Constant(body.exact.size(), 1.0 / 60);
  return body;
}

Body torusBody(const char* name, double ring, double tube, int around, int across) {
  Body body{name, test::torus(ring, tube, around, across), {}};
  body.curvature.resize(body.exact.size());
  for (Index i = 0; i < body.exact.size(); ++i) {
    const double away = body.exact.points.row(i).head<2>().norm();
    body.curvature[i] = (1 / tube + (away - ring) / tube / away) / 2;
  }
  return body;
}

Body liverBody() {
  Body body{"built-in liver, 1.3 mm edges", makeSyntheticLiver({}).surface, {}};
  CurvatureSettings settings;
  settings.radiusMm = 3;
  body.curvature = meanCurvature(body.exact, settings);
  return body;
}

Surface noisy(const Surface& exact) {
  Surface surface = exact;
  surface.arrays.clear();
  const Points normals = vertexNormals(exact);
  Draws draws(1);
  for (Index i = 0; i < surface.size(); ++i)
    surface.points.row(i) += kNoiseMm * draws.normal() * normals.row(i);
  return surface;
}

/// RMS distance, RMS and 95 % angle of the normals, RMS error of curvature over RMS curvature, against the
/// exact body's nearest place.
void row(const Body& body, const char* method, const Surface& result, const Points& normals,
         const VectorXd& curvature, const Spent& spent) {
  const TriangleTree tree(body.exact);
  const Points truth = vertexNormals(body.exact);
  double distance = 0, angle = 0, error = 0, all = 0, largest = 0;
  for (Index i = 0; i < result.size(); ++i) {
    const ClosestPlace place = tree.closest(result.points.row(i));
    Vector3d normal = Vector3d::Zero();
    double h = 0;
    for (int c = 0; c < 3; ++c) {
      const int v = tree.vertexOf(place.triangle, c);
      normal += place.barycentric[c] * truth.row(v).transpose();
      h += place.barycentric[c] * body.curvature[v];
    }
    const double a = std::acos(std::clamp(normal.normalized().dot(normals.row(i).transpose()), -1.0, 1.0)) *
                     180 / std::numbers::pi;
    distance += place.distance * place.distance;
    angle += a * a;
    largest = std::max(largest, a);
    error += std::pow(curvature[i] - h, 2);
    all += h * h;
  }
  const auto n = static_cast<double>(result.size());
  std::printf("| %s | %s | %.3f | %.2f | %.1f | %.1f | %.1f | %.1f |\n", body.name, method,
              std::sqrt(distance / n), std::sqrt(angle / n), largest, 100 * std::sqrt(error / all),
              spent.wallMs / 1000, spent.cpuMs / 1000);
  std::fflush(stdout);
}

/// As many points as the body has, drawn evenly from its triangles, without triangles of their own.
Surface evenCloud(const Body& body) {
  VectorXd below(body.exact.triangles.rows());  // twice the area of the triangles up to each
  for (Index t = 0; t < below.size(); ++t) {
    const auto corner = [&](int c) -> Vector3d { return body.exact.points.row(body.exact.triangles(t, c)); };
    below[t] = (t == 0 ? 0 : below[t - 1]) + (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  const Points normals = vertexNormals(body.exact);
  Surface cloud;
  cloud.points.resize(body.exact.size(), 3);
  cloud.normals.resize(body.exact.size(), 3);
  Draws draws(2);
  for (Index i = 0; i < cloud.size(); ++i) {
    const double wanted = draws.uniform() * below[below.size() - 1];
    const Index t = std::lower_bound(below.begin(), below.end(), wanted) - below.begin();
    double u = draws.uniform(), v = draws.uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto corners = body.exact.triangles.row(t);
    const auto mixed = [&](const Points& of) -> Vector3d {
      return ((1 - u - v) * of.row(corners[0]) + u * of.row(corners[1]) + v * of.row(corners[2])).transpose();
    };
    cloud.normals.row(i) = mixed(normals).normalized().transpose();
    cloud.points.row(i) =
        mixed(body.exact.points).transpose() + kNoiseMm * draws.normal() * cloud.normals.row(i);
  }
  return cloud;
}

void rbfRow(const Body& body, const char* method, const Surface& input) {
  RbfSurfaceResult fitted;
  const Spent spent = measured([&] { fitted = smoothByRbf(input, {}); });
  row(body, method, fitted.surface, fitted.surface.normals, fitted.surface.arrays.at(kMeanCurvature), spent);
}

void compare(const Body& body) {
  const Surface input = noisy(body.exact);
  rbfRow(body, "radial basis functions", input);
  rbfRow(body, "the same from points spread evenly", evenCloud(body));
  Surface sinc;
  const Spent spent = measured([&] { sinc = smoothWindowedSinc(input, kIterations, kPassBand); });
  CurvatureSettings wide;
  wide.radiusMm = 10;
  row(body, "windowed sinc, curvature over 10 mm", sinc, vertexNormals(sinc), meanCurvature(sinc, wide),
      spent);
  row(body, "none, curvature over 10 mm", input, vertexNormals(input), meanCurvature(input, wide), {});
}

int run() {
  setThreads(kThreads);
  std::printf("%d threads; noise of %.1f mm along the normals.\n\n", kThreads, kNoiseMm);
  std::puts(
      "| body | smoothed by | RMS distance, mm | normals, RMS, deg | largest, deg | mean curvature, RMS "
      "error, % | "
      "s | processor s |\n|---|---|---|---|---|---|---|---|");
  compare(sphereBody());
  compare(torusBody("torus of 80 and 50 mm, 60,000 points", 80, 50, 300, 200));
  compare(torusBody("torus of 60 and 25 mm, 41,600 points", 60, 25, 260, 160));
  compare(liverBody());
  const auto file = test::realData() / "update/ircad17_left/preop.vtp";
  if (!std::filesystem::exists(file)) return 0;
  const Surface liver = readSurface(file).value;
  RbfSurfaceResult fitted;
  const Spent spent = measured([&] { fitted = smoothByRbf(liver, {}); });
  std::printf(
      "\nReal liver, %d points: %d points after, noise found %.2f mm, points %.2f mm RMS and %.1f mm at most "
      "from the surface, %.1f s, %.1f processor s.\n",
      static_cast<int>(liver.size()), static_cast<int>(fitted.surface.size()), fitted.fit.noiseMm,
      fitted.rmsMm, fitted.largestMm, spent.wallMs / 1000, spent.cpuMs / 1000);
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main() { return falciform::bench::run(); }
