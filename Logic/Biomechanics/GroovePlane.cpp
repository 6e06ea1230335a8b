#include "Logic/Biomechanics/GroovePlane.h"

#include "Logic/Core/Errors.h"

namespace falciform {
GroovePlane groovePlane(const Surface& preop) {
  if (preop.size() == 0)
    throw InputError("the pre-operative surface has no points; import or open a liver first");
  GroovePlane plane;
  const std::vector<int> painted = pointsOfPatch(preop, patch::kFalciform);
  if (painted.size() < 3) {
    plane.point = (preop.points.colwise().minCoeff() + preop.points.colwise().maxCoeff()).transpose() / 2;
    return plane;
  }
  plane.painted = true;
  plane.point = preop.points(painted, Eigen::all).colwise().mean().transpose();
  return plane;
}

}  // namespace falciform
