#include "Logic/Patches/CrestStrength.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

namespace {

constexpr double kAcross = 0.8;      ///< cosine: a neighbour lies across the crest
constexpr double kSharpMm = 8;       ///< a crest rounded by this radius or less is as sharp as can be
constexpr double kLeastCost = 0.05;  ///< so that even on a crest the shorter path wins

}  // namespace

VectorXd crestCurvature(const Curvatures& curvatures, CrestKind kind) {
  const VectorXd k = kind == CrestKind::Ridge ? curvatures.k1 : VectorXd(-curvatures.k2);
  return k.unaryExpr([](double value) { return value > 0 ? value : 0.0; });  // not-a-number goes too
}

VectorXd crestPeak(const Surface& surface, const Curvatures& curvatures, CrestKind kind, double reachMm) {
  const VectorXd k = crestCurvature(curvatures, kind);
  const Points& direction = kind == CrestKind::Ridge ? curvatures.direction1 : curvatures.direction2;
  const KdTree tree(surface.points);
  VectorXd peak = VectorXd::Zero(surface.size());
  forEachChunk(static_cast<std::size_t>(surface.size()), 256, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      if (!(k[i] > 0)) continue;
      double largest = k[i];
      for (const int j : tree.within(surface.points.row(i), reachMm)) {
        if (k[j] <= largest) continue;
        const Vector3d aside = surface.points.row(j) - surface.points.row(i);
        if (std::abs(aside.dot(direction.row(i).transpose())) >= kAcross * aside.norm()) largest = k[j];
      }
      peak[i] = k[i] / largest;
    }
  });
  return peak;
}

VectorXd crestCost(const Surface& surface, CrestKind kind, double scaleMm) {
  if (!(scaleMm >= 1 && scaleMm <= 50))
    throw InputError("a crest's scale is " + std::to_string(scaleMm) + " mm; choose from 1 to 50 mm");
  CurvatureSettings settings;
  settings.radiusMm = scaleMm;
  const Curvatures curvatures = principalCurvatures(surface, settings);
  const VectorXd k = crestCurvature(curvatures, kind);
  const VectorXd peak = crestPeak(surface, curvatures, kind, scaleMm);
  return (1 - (1 - kLeastCost) * peak.array() * (k.array() * kSharpMm).min(1)).matrix();
}

}  // namespace falciform
