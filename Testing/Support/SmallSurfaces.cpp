#include "Testing/Support/SmallSurfaces.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <vector>

namespace falciform::test {

namespace {

Surface fromLists(const std::vector<Vector3d>& points, const std::vector<Vector3i>& triangles) {
  Surface surface;
  surface.points.resize(static_cast<Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    surface.points.row(static_cast<Index>(i)) = points[i].transpose();
  surface.triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    surface.triangles.row(static_cast<Index>(i)) = triangles[i].transpose();
  return surface;
}

}  // namespace

Surface sphere(double radiusMm, int subdivisions, const Vector3d& centre) {
  const double g = std::numbers::phi;
  std::vector<Vector3d> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                               {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Vector3i> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int step = 0; step < subdivisions; ++step) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (fresh)
        points.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]) / 2);
      return place->second;
    };
    std::vector<Vector3i> finer;
    for (const Vector3i& t : triangles) {
      const int ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
    }
    triangles = finer;
  }
  for (Vector3d& p : points) p = centre + radiusMm * p.normalized();
  return fromLists(points, triangles);
}

Surface box(const Vector3d& size) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1) * size.x(), (i >> 1 & 1) * size.y(), (i >> 2 & 1) * size.z());
  return fromLists(points, {{0, 2, 3},
                            {0, 3, 1},
                            {4, 5, 7},
                            {4, 7, 6},
                            {0, 1, 5},
                            {0, 5, 4},
                            {2, 6, 7},
                            {2, 7, 3},
                            {0, 4, 6},
                            {0, 6, 2},
                            {1, 3, 7},
                            {1, 7, 5}});
}

Surface grid(double sizeMm, int cells) {
  std::vector<Vector3d> points;
  std::vector<Vector3i> triangles;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) points.emplace_back(x * sizeMm / cells, y * sizeMm / cells, 0);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const int a = y * (cells + 1) + x, b = a + 1, c = a + cells + 1, d = c + 1;
      if ((x + y) % 2)
        triangles.insert(triangles.end(), {{a, b, d}, {a, d, c}});
      else
        triangles.insert(triangles.end(), {{a, b, c}, {b, d, c}});
    }
  return fromLists(points, triangles);
}

Surface torus(double ringRadiusMm, double tubeRadiusMm, int ringSegments, int tubeSegments) {
  std::vector<Vector3d> points;
  std::vector<Vector3i> triangles;
  for (int i = 0; i < ringSegments; ++i)
    for (int j = 0; j < tubeSegments; ++j) {
      const double u = 2 * std::numbers::pi * i / ringSegments, v = 2 * std::numbers::pi * j / tubeSegments;
      const double r = ringRadiusMm + tubeRadiusMm * std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), tubeRadiusMm * std::sin(v));
      const int i2 = (i + 1) % ringSegments, j2 = (j + 1) % tubeSegments;
      const int a = i * tubeSegments + j, b = i2 * tubeSegments + j, c = i2 * tubeSegments + j2,
                d = i * tubeSegments + j2;
      triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
    }
  return fromLists(points, triangles);
}

Surface lumpyBody(int subdivisions) {
  Surface body = sphere(1, subdivisions);
  body.patch.assign(static_cast<std::size_t>(body.size()), patch::kNone);
  for (Index i = 0; i < body.size(); ++i) {
    const Vector3d d = body.points.row(i).transpose();
    const double bump = 1 + 0.18 * std::sin(2.1 * d.x() + 1.3 * d.y()) +
                        0.12 * std::sin(3.7 * d.z() - 2.2 * d.x() + 0.4) +
                        0.07 * std::cos(5.3 * d.y() + 1.9 * d.z());
    if (d.z() > 0.3 && std::abs(d.x() - 0.1) < 0.06)
      body.patch[static_cast<std::size_t>(i)] = patch::kFalciform;
    if (d.y() < -0.4 && std::abs(d.z() - 0.15 * d.x()) < 0.05)
      body.patch[static_cast<std::size_t>(i)] = patch::kInferiorRidge;
    body.points.row(i) = (bump * d.cwiseProduct(Vector3d(100, 70, 60))).transpose();
  }
  return body;
}

Isometry3d randomMotion(unsigned seed, double translationMm) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-translationMm, translationMm);
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
  return Eigen::Translation3d(uniform(random), uniform(random), uniform(random)) * Isometry3d(turn);
}

}  // namespace falciform::test
