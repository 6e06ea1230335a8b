#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// A place inside the liver: where it was, and where registration and update say it is now.
struct UpdatedTarget {
  std::string name;
  bool structure = false;              ///< the middle of a structure's surface, not a target of the case
  Vector3d before = Vector3d::Zero();  ///< pre-op mm
  Vector3d rigid = Vector3d::Zero();   ///< scan mm, by the registration
  Vector3d now = Vector3d::Zero();     ///< scan mm, by the update
  double expectedErrorMm = 0;          ///< of `now`
  std::optional<double> trueErrorMm;   ///< of `now`, where the truth is known
  std::optional<double> rigidErrorMm;  ///< of `rigid`
};

/// What a model update came to, without the model it was made with: what a case keeps of it, to be looked at
/// again.
struct KeptUpdate {
  /// The pre-op surface where it is now, scan mm, point for point; with the arrays of UpdatedCase::surface.
  std::shared_ptr<const Surface> surface;
  std::map<std::string, std::shared_ptr<const Surface>> structures;  ///< where they are now, scan mm
  std::vector<UpdatedTarget> targets;  ///< those of the case, then the middles of the structures
  Isometry3d scanFromPreop = Isometry3d::Identity();  ///< the update's own rigid motion
  double expectedErrorMeanMm = 0;                     ///< over the surface's points
  double rmsMm = 0;                                   ///< fit, not target error
  double bendMm = 0, largestMm = 0;                   ///< bending: RMS, largest
  double minDetJ = 1;                                 ///< smallest local ratio of volumes
  double effectiveParameters = 0;                     ///< loads that the scan determines
  double seconds = 0;
  int iterations = 0;
  bool converged = false;
  std::string stopReason;
  std::vector<std::string> warnings;
};

}  // namespace falciform
