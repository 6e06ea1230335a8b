#pragma once
#include <memory>
#include <vector>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Case.h"

// The built-in liver on coarse triangles, and what a scanner in front of it sees once its left end has been
// lifted: a case for model updates that takes no time. For tests that depend on Falciform::Acquisition.

namespace falciform::test {

inline const SyntheticLiver& coarseLiver() {
  static const SyntheticLiver made = [] {
    SyntheticLiverSettings shape;
    shape.edgeLengthMm = 6;
    return makeSyntheticLiver(shape);
  }();
  return made;
}

/// A place of the liver with its left end lifted to the front, by a smooth bend of up to `liftMm`.
inline Vector3d lifted(const Vector3d& preop, double liftMm) {
  const auto along = coarseLiver().surface.points.col(0);
  const double share = (preop.x() - along.minCoeff()) / (along.maxCoeff() - along.minCoeff());
  return preop - Vector3d(0, liftMm * share * share, 0);
}

/// Points of its front half, painted and lifted, in the scanner's frame.
inline Surface scanOfLifted(double liftMm, const Isometry3d& scanFromPreop) {
  const Surface& whole = coarseLiver().surface;
  const double front = whole.points.col(1).mean();
  std::vector<int> seen;
  for (int i = 0; i < whole.size(); ++i)
    if (whole.points(i, 1) < front) seen.push_back(i);
  Surface scan;
  scan.points = whole.points(seen, Eigen::all);
  for (Index i = 0; i < scan.size(); ++i)
    scan.points.row(i) = lifted(scan.points.row(i).transpose(), liftMm).transpose();
  scan.patchNames = whole.patchNames;
  for (const int id : seen) scan.patch.push_back(whole.patch[static_cast<std::size_t>(id)]);
  scan.points = transformed(scan.points, scanFromPreop);
  scan.frame = "scanner";
  return scan;
}

/// Liver, structures, targets, scan, and the pose that the scan was made with as its registration.
inline void fillLifted(Case& document, double liftMm, const Isometry3d& scanFromPreop) {
  document.setPreop(std::make_shared<const Surface>(coarseLiver().surface));
  for (const auto& [name, surface] : coarseLiver().structures)
    document.setStructure(name, std::make_shared<const Surface>(surface));
  document.setTargets(coarseLiver().targets);
  document.setScan(std::make_shared<const Surface>(scanOfLifted(liftMm, scanFromPreop)));
  RegistrationResult registration;
  registration.scanFromPreop = scanFromPreop;
  document.setRegistration(std::make_shared<const RegistrationResult>(registration));
}

/// Where the targets truly are, scan mm.
inline Landmarks truthOfLifted(double liftMm, const Isometry3d& scanFromPreop) {
  Landmarks truth = coarseLiver().targets;
  truth.frame = "scanner";
  for (Landmark& target : truth.points) target.position = scanFromPreop * lifted(target.position, liftMm);
  return truth;
}

}  // namespace falciform::test
