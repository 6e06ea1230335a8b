#include "Logic/Acquisition/PhantomPainting.h"

#include <cmath>

#include "Logic/Core/Surface.h"

namespace falciform {
namespace {

// Chosen so that the thesis's counts come out on the default phantom; lengths in mm.
constexpr double kFalciformHalfWidth = 6.1, kFalciformTop = 55;
constexpr double kRidgeReach = 4.2, kRidgeLeft = -3, kRidgeRight = -92;

int labelAt(const LiverShape& liver, const Vector3d& p) {
  const double groove = liver.leftOfGroove(p);
  const double below = liver.diaphragmatic(p) - liver.visceral(p);  // positive on the diaphragmatic face
  if (std::abs(groove) < kFalciformHalfWidth && below > 1 && p.y() < liver.place(0, 30, 0).y() &&
      p.z() < liver.place(0, 0, kFalciformTop).z())
    return patch::kFalciform;
  if (std::abs(below) < kRidgeReach && groove < kRidgeLeft && groove > kRidgeRight &&
      p.y() < liver.place(0, 4, 0).y())
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
  // A window of 120 x 116 mm with round corners in the frontal plane, over the notch.
  const Vector3d middle = liver.place(-20, 0, -25);
  const double halfX = 60, halfZ = 58;
  std::vector<int> ids;
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d d = points.row(i).transpose() - middle;
    if (std::pow(d.x() / halfX, 4) + std::pow(d.z() / halfZ, 4) < 1) ids.push_back(static_cast<int>(i));
  }
  return ids;
}

}  // namespace falciform
