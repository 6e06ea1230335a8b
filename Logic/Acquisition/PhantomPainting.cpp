#include "Logic/Acquisition/PhantomPainting.h"

#include <cmath>

#include "Logic/Core/Surface.h"

namespace falciform {
namespace {

// Chosen so that the thesis's counts come out on the default phantom; lengths in mm.
constexpr double kFalciformHalfWidth = 7.5, kFalciformTop = 45;
constexpr double kRidgeReach = 2.2, kRidgeLeft = -12, kRidgeRight = -115;

int labelAt(const LiverShape& liver, const Vector3d& p) {
  const double groove = liver.leftOfGroove(p);
  if (p.y() > liver.place(0, 4, 0).y()) return patch::kNone;
  const double below = liver.diaphragmatic(p) - liver.visceral(p);  // positive on the diaphragmatic face
  if (std::abs(groove) < kFalciformHalfWidth && below > 1 && p.z() < liver.place(0, 0, kFalciformTop).z())
    return patch::kFalciform;
  if (std::abs(below) < kRidgeReach && groove < kRidgeLeft && groove > kRidgeRight)
    return patch::kInferiorRidge;
  return patch::kNone;
}

}  // namespace

std::vector<int> paintPhantomScan(const LiverShape& liver, const Points& points) {
  std::vector<int> labels;
  labels.reserve(static_cast<std::size_t>(points.rows()));
  for (Index i = 0; i < points.rows(); ++i) labels.push_back(labelAt(liver, points.row(i).transpose()));
  return labels;
}

std::vector<int> surgicalSubRegion(const LiverShape& liver, const Points& points) {
  const Vector3d middle = liver.place(-38, 0, -2), half = liver.place(62, 0, 48) - liver.place(0, 0, 0);
  std::vector<int> ids;
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d d = points.row(i).transpose() - middle;
    if (std::hypot(d.x() / half.x(), d.z() / half.z()) < 1) ids.push_back(static_cast<int>(i));
  }
  return ids;
}

}  // namespace falciform
