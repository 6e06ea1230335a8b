#include "Logic/Acquisition/LiverPainting.h"

#include <cmath>
#include <functional>

#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr double kFalciformHalfWidth = 5;  // mm; narrower than the groove's bell of 6 mm: all of it hollow
constexpr double kRidgeReach =
    7;  // mm between the two surfaces' distances, about 7 mm either side of the margin

int labelAt(const LiverShape& shape, const Vector3d& p) {
  const double groove = shape.leftOfGroove(p);
  const double front = shape.place(0, 4, 0).y();
  if (p.y() > front) return patch::kNone;
  // On the diaphragmatic face the visceral surface is far below, and the reverse.
  const double below = shape.diaphragmatic(p) - shape.visceral(p);
  if (std::abs(groove) < kFalciformHalfWidth && below > 1 && shape.grooveStrength(p) > 0.3)
    return patch::kFalciform;
  if (std::abs(below) < kRidgeReach && groove < -0.6 * kFalciformHalfWidth) return patch::kInferiorRidge;
  return patch::kNone;
}

}  // namespace

std::vector<int> paintPatches(const LiverShape& shape, const Points& points) {
  std::vector<int> labels(static_cast<std::size_t>(points.rows()));
  forEachChunk(labels.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      labels[i] = labelAt(shape, points.row(static_cast<Index>(i)).transpose());
  });
  return labels;
}

Landmarks anatomicalLandmarks(const LiverShape& shape, const Points& points) {
  const auto margin = [&](const Vector3d& p) {  // how far from the front part of the inferior margin
    return std::abs(shape.diaphragmatic(p) - shape.visceral(p)) +
           10 * std::max(p.y() - shape.place(0, -20, 0).y(), 0.0);
  };
  const Vector3d fundus = shape.place(-45, 0, 0), top = shape.place(0, -18, 0),
                 cava = shape.place(-18, 42, 0);
  const std::pair<const char*, std::function<double(const Vector3d&)>> sought[] = {
      {"falciform notch", [&](const Vector3d& p) { return margin(p) + std::abs(shape.leftOfGroove(p)); }},
      {"falciform top",
       [&](const Vector3d& p) {
         return std::abs(shape.leftOfGroove(p)) + std::abs(p.y() - top.y()) + (p.z() < 20 ? 100 : 0);
       }},
      {"dome", [](const Vector3d& p) { return -p.z(); }},
      {"right lower tip", [](const Vector3d& p) { return p.z(); }},
      {"left tip", [](const Vector3d& p) { return -p.x(); }},
      {"gallbladder fundus", [&](const Vector3d& p) { return margin(p) + std::abs(p.x() - fundus.x()); }},
      {"caval bed", [&](const Vector3d& p) { return (p - cava).head<2>().norm() - 0.3 * p.z(); }},
  };
  Landmarks found;
  for (const auto& [name, cost] : sought) {
    Index best = 0;
    double lowest = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < points.rows(); ++i) {
      const double value = cost(points.row(i).transpose());
      if (value < lowest) lowest = value, best = i;
    }
    found.points.push_back({name, points.row(best).transpose()});
  }
  return found;
}

}  // namespace falciform
