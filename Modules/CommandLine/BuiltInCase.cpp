#include "Modules/CommandLine/BuiltInCase.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "Logic/Geometry/Measures.h"

namespace falciform::commandline {

namespace {

Surface deformed(const Surface& surface, const Eigen::Matrix<double, 2, 3>& box,
                 const BuiltInChangeSettings& settings) {
  Surface moved = surface;
  for (Index i = 0; i < moved.size(); ++i)
    moved.points.row(i) += builtInDisplacement(surface.points.row(i), box, settings).transpose();
  if (moved.normals.rows() > 0) moved.normals = vertexNormals(moved);
  return moved;
}

Landmarks seenByScanner(const Landmarks& landmarks, const Eigen::Matrix<double, 2, 3>& box,
                        const BuiltInChangeSettings& settings, const VirtualScan& scan) {
  Landmarks seen;
  seen.frame = scan.scan.frame;
  for (const Landmark& point : landmarks.points)
    seen.points.push_back(
        {point.name,
         scan.scanFromPreop * (point.position + builtInDisplacement(point.position, box, settings))});
  return seen;
}

}  // namespace

Vector3d builtInDisplacement(const Vector3d& point, const Eigen::Matrix<double, 2, 3>& box,
                             const BuiltInChangeSettings& settings) {
  const Vector3d low = box.row(0), size = box.row(1) - box.row(0);
  const Vector3d share =
      (point - low).cwiseQuotient(size);  // 0 to 1: right to left, front to back, foot to head
  // The left lobe, freed from its ligament, sinks towards the back, more the farther out.
  const double out = std::clamp((share.x() - 0.45) / 0.55, 0.0, 1.0);
  const Vector3d sinking = out * out * Vector3d(0.0, 0.9, -0.43);
  // Packing lifts the right lobe from below; a Gaussian of a third of the width.
  const Vector3d from = share - Vector3d(0.25, 0.5, 0.1);
  const Vector3d packing =
      0.7 * std::exp(-from.squaredNorm() / (2 * 0.33 * 0.33)) * Vector3d(0.15, -0.25, 0.95);
  return settings.deformationMm * (sinking + packing);
}

BuiltInCase makeBuiltInCase(const BuiltInCaseSettings& settings, const Progress& progress) {
  BuiltInCase made;
  made.liver = makeSyntheticLiver(settings.liver, progress.part(0.0, 0.5));
  made.labelMap = makeSyntheticLabelMap(settings.liver, progress.part(0.5, 0.8));
  progress.report(0.8, "Scanning");
  const Eigen::Matrix<double, 2, 3> box = boundingBox(made.liver.surface.points);
  const Surface changed = deformed(made.liver.surface, box, settings.change);
  made.scan = scanSurface(changed, settings.scanner, progress.part(0.8, 1.0));
  made.truthTargets = seenByScanner(made.liver.targets, box, settings.change, made.scan);
  made.scanLandmarks = seenByScanner(made.liver.anatomical, box, settings.change, made.scan);
  std::mt19937_64 random(static_cast<std::uint64_t>(settings.change.seed));
  std::normal_distribution<double> normal(0.0, 1.0);
  for (Landmark& point : made.scanLandmarks.points)
    for (int axis = 0; axis < 3; ++axis)
      point.position[axis] += settings.change.landmarkErrorMm * normal(random);
  return made;
}

}  // namespace falciform::commandline
