#include "Logic/Deformation/Normalisation/SurfaceErrors.h"

#include "Logic/Geometry/SurfaceDistances.h"

namespace falciform {

SurfaceErrors surfaceErrors(const Surface& target, const Surface& source, const LiverMap& map) {
  SurfaceErrors errors;
  errors.moved = source;
  errors.moved.points = map.toTarget(source.points);
  errors.moved.normals.resize(0, 3);
  errors.sourceToTarget = distancesTo(target, errors.moved.points);
  errors.targetToSource = distancesTo(errors.moved, target.points);
  return errors;
}

}  // namespace falciform
