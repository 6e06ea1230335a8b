#pragma once
#include <memory>

#include "Logic/Atlas/UpdateMethods.h"
#include "Testing/Benchmarks/UpdateTrial.h"

namespace falciform::bench {

/// What an update makes of a trial, and what it started from.
struct MethodOutcome {
  ErrorFigures rigid, updated;
  VectorXd updatedMm;  ///< by place
  Points places;       ///< where it says that they are, scan mm
  UpdateResult update;
};

/// An atlas's modes in place of surface loads, for our own fit: joint with the pose, point to plane, its
/// regularisation learnt.
[[nodiscard]] LoadResponses modesAsLoads(const Atlas& atlas, const Surface& preop);

/// Where pre-op places are by any method's result, scan mm.
[[nodiscard]] Points placesNow(const TetrahedralMesh& mesh, const UpdateResult& update,
                               const Points& preopMm);

/// The methods of thesis ch. V and ours on one liver with one atlas.
class ThesisMethods {
 public:
  ThesisMethods(const Surface& preop, std::shared_ptr<const Atlas> atlas);

  /// From a given pose. `Loads`: ours, with the atlas's modes and `own` settings.
  [[nodiscard]] MethodOutcome update(UpdateMethod method, const UpdateTrial& trial,
                                     const Isometry3d& scanFromPreop, const UpdateSettings& own = {}) const;
  /// The thesis's start: ICP, or PICP with the falciform patch, from how the frames lie.
  [[nodiscard]] Isometry3d icp(const ReadyLiver& liver, const UpdateTrial& trial) const;
  [[nodiscard]] Isometry3d picp(const ReadyLiver& liver, const UpdateTrial& trial) const;

 private:
  std::shared_ptr<const Atlas> atlas_;
  PreparedUpdate icat_, icatStar_;
  UpdateModel own_;
};

}  // namespace falciform::bench
