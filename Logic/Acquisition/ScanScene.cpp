#include "Logic/Acquisition/ScanScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "Logic/Acquisition/TissueColour.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kDrapeBehind = 10, kDrapeStep = 4;  // mm
constexpr double kRodRadius = 4, kRodLength = 220;   // mm
constexpr int kRodSides = 24;

/// Adds points (rows) and triangles, counted from the first of them, of one structure.
void append(ScanScene& scene, const std::vector<Vector3d>& points,
            const std::vector<std::array<int, 3>>& triangles, int structure) {
  Surface& surface = scene.surface;
  const Index first = surface.size(), firstTriangle = surface.triangles.rows();
  surface.points.conservativeResize(first + static_cast<Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    surface.points.row(first + static_cast<Index>(i)) = points[i].transpose();
  surface.triangles.conservativeResize(firstTriangle + static_cast<Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      surface.triangles(firstTriangle + static_cast<Index>(t), k) =
          static_cast<int>(first) + triangles[t][static_cast<std::size_t>(k)];
  scene.structure.resize(static_cast<std::size_t>(surface.size()), structure);
  if (!surface.patch.empty()) surface.patch.resize(static_cast<std::size_t>(surface.size()), patch::kNone);
}

/// Waves of three lengths in drawn directions, mm.
class Waves {
 public:
  explicit Waves(Draws draws) {
    for (std::size_t w = 0; w < kLengths.size(); ++w) {
      const double turn = draws.uniform(0, kTwoPi);
      waves_[w] = {std::cos(turn), std::sin(turn), draws.uniform(0, kTwoPi)};
    }
  }
  [[nodiscard]] double height(double x, double y) const {
    double sum = 0;
    for (std::size_t w = 0; w < kLengths.size(); ++w)
      sum +=
          kHeights[w] * std::sin(kTwoPi * (waves_[w][0] * x + waves_[w][1] * y) / kLengths[w] + waves_[w][2]);
    return sum;
  }

 private:
  static constexpr std::array<double, 3> kLengths{140, 85, 50}, kHeights{4, 2.5, 1.2};
  std::array<std::array<double, 3>, 3> waves_{};
};

void addDrape(ScanScene& scene, const ScannerView& view, const Vector3d& middle, double halfEdge,
              Draws draws) {
  const Waves waves(draws);
  const int count = static_cast<int>(std::ceil(2 * halfEdge / kDrapeStep)) + 1;
  std::vector<Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i) {
      const double x = i * kDrapeStep - halfEdge, y = j * kDrapeStep - halfEdge;
      points.emplace_back(middle + x * view.right + y * view.down +
                          (kDrapeBehind - waves.height(x, y)) * view.forward);
      if (i == 0 || j == 0) continue;
      const int here = j * count + i, left = here - 1, up = here - count, upLeft = up - 1;
      // right x down = forward: this order faces the scanner.
      triangles.push_back({upLeft, left, up});
      triangles.push_back({up, left, here});
    }
  append(scene, points, triangles, structure::kDrape);
}

/// A closed rod from `tip` along `axis`.
void addRod(ScanScene& scene, const Vector3d& tip, const Vector3d& axis) {
  const Vector3d side = axis.unitOrthogonal(), other = axis.cross(side);
  std::vector<Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
  for (int s = 0; s < kRodSides; ++s) {
    const double turn = kTwoPi * s / kRodSides;
    const Vector3d rim = kRodRadius * (std::cos(turn) * side + std::sin(turn) * other);
    points.emplace_back(tip + rim);
    points.emplace_back(tip + rim + kRodLength * axis);
    const int low = 2 * s, high = low + 1, nextLow = 2 * ((s + 1) % kRodSides), nextHigh = nextLow + 1;
    triangles.push_back({low, nextLow, high});
    triangles.push_back({high, nextLow, nextHigh});
    triangles.push_back({2 * kRodSides, nextLow, low});
    triangles.push_back({2 * kRodSides + 1, high, nextHigh});
  }
  points.push_back(tip);
  points.emplace_back(tip + kRodLength * axis);
  append(scene, points, triangles, structure::kInstrument);
}

}  // namespace

ScanScene makeScanScene(const Surface& organ, const ScannerView& view, const ScanFaultSettings& faults) {
  ScanScene scene{organ, {}};
  if (const auto own = organ.arrays.find(structure::kArray); own != organ.arrays.end())
    for (const double source : own->second) scene.structure.push_back(static_cast<int>(source));
  if (faults.instruments == 0 && !faults.drape) return scene;
  if (scene.structure.empty())
    scene.structure.assign(static_cast<std::size_t>(organ.size()), structure::kOrgan);
  // What belongs to the organ's points only does not go with the scene.
  scene.surface.normals.resize(0, 3);
  scene.surface.colours.resize(0, 3);
  scene.surface.arrays.clear();
  const auto seed = static_cast<std::uint64_t>(faults.faultSeed);
  const Vector3d middle = centroid(organ.points);
  const double reach = (organ.points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
  if (faults.instruments > 0) {
    const TriangleTree tree(organ);
    Draws draws(seed, 20);
    for (int n = 0, tries = 0; n < faults.instruments && tries < 1000; ++tries) {
      const double turn = draws.uniform(0, kTwoPi), off = reach * draws.uniform(0.1, 0.6),
                   lean = draws.uniform(50, 70) * std::numbers::pi / 180, gap = draws.uniform(3, 12);
      const Vector3d radial = std::cos(turn) * view.right + std::sin(turn) * view.down;
      const auto hit = tree.cast(view.eye, middle + off * radial - view.eye);
      if (!hit) continue;
      addRod(scene, hit->point - (gap + kRodRadius) * view.forward,
             std::sin(lean) * radial - std::cos(lean) * view.forward);
      ++n;
    }
  }
  if (faults.drape) addDrape(scene, view, middle, 1.6 * reach, Draws(seed, 21));
  return scene;
}

double organArea(const ScanScene& scene) {
  if (scene.structure.empty()) return area(scene.surface);
  Surface organ = scene.surface;
  Index kept = 0;
  for (Index t = 0; t < organ.triangles.rows(); ++t)
    if (scene.structure[static_cast<std::size_t>(organ.triangles(t, 0))] == structure::kOrgan)
      organ.triangles.row(kept++) = scene.surface.triangles.row(t);
  organ.triangles.conservativeResize(kept, 3);
  return area(organ);
}

bool hasRoom(const ScanFaultSettings& faults) {
  return faults.drape || faults.instruments > 0 || faults.smoke > 0;
}

Surface organOf(const Surface& scan) {
  const auto source = scan.arrays.find(structure::kArray);
  if (source == scan.arrays.end()) return scan;
  std::vector<int> ids;
  for (Index i = 0; i < scan.size(); ++i)
    if (source->second[i] == structure::kOrgan) ids.push_back(static_cast<int>(i));
  Surface organ = subset(scan, ids);
  organ.arrays.erase(structure::kArray);
  return organ;
}

std::array<std::uint8_t, 3> sceneColour(int structure, const Vector3d& place, int patchLabel) {
  if (structure == structure::kOrgan) return tissueColour(place, patchLabel);
  if (structure == structure::kTeflon) return {236, 236, 230};
  const Vector3d paint = structure == structure::kDrape        ? Vector3d(38, 104, 112)
                         : structure == structure::kInstrument ? Vector3d(168, 170, 176)
                                                               : Vector3d(205, 203, 200);
  // The organ's own mottling, on another ground.
  const auto mottled = tissueColour(place, patch::kNone),
             plain = tissueColour(Vector3d(0, 0, 0), patch::kNone);
  const double light = static_cast<double>(mottled[0]) / std::max<double>(plain[0], 1);
  std::array<std::uint8_t, 3> rgb{};
  for (std::size_t k = 0; k < 3; ++k)
    rgb[k] =
        static_cast<std::uint8_t>(std::lround(std::clamp(paint[static_cast<Index>(k)] * light, 0.0, 255.0)));
  return rgb;
}

}  // namespace falciform
