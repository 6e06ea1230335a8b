#pragma once
#include <string>
#include <vector>

#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform::bench {

/// Lengths of errors at known places, mm.
struct ErrorFigures {
  double mean = 0, sd = 0, largest = 0;
};
[[nodiscard]] ErrorFigures figuresOf(const VectorXd& errorsMm);
/// Of places where they were said to be and where they are, N x 3 each, mm.
[[nodiscard]] ErrorFigures figuresOf(const Points& saidMm, const Points& trueMm);
/// "1.2±0.4(2.3)" as the thesis prints, or without the spread: "1.2(2.3)".
[[nodiscard]] std::string asInThesis(const ErrorFigures& figures, int digits = 1);
[[nodiscard]] std::string withoutSpread(const ErrorFigures& figures, int digits = 1);

/// A liver made ready for any number of scans, as `falciform update` does it.
class ReadyLiver {
 public:
  /// `edgeMm`: of the mesh. Surfaces with edges above 3 mm are subdivided for the registration, which looks
  /// for the nearest point.
  explicit ReadyLiver(const Surface& preop, double edgeMm = 13);

  [[nodiscard]] const PreparedPreop& rigid() const { return rigid_; }
  [[nodiscard]] const UpdateModel& model() const { return model_; }

 private:
  PreparedPreop rigid_;
  UpdateModel model_;
};

/// A scan of a liver that has moved, and places whose motion is known.
struct UpdateTrial {
  Surface scan;
  Points before;  ///< pre-op mm
  Points after;   ///< the same places where they truly are, in the scan's frame, mm
  /// How the frames lie, deformation apart: what markers beside the liver would tell. For methods that need
  /// a start near by; ours is not told.
  Isometry3d scanFromPreop = Isometry3d::Identity();
};

struct TrialResult {
  ErrorFigures optimal;  ///< of the best rigid motion of these very places
  ErrorFigures registered, updated;
  VectorXd updatedMm;     ///< error by place
  double expectedMm = 0;  ///< mean error that the update expects of itself, truth unseen
  RegistrationResult rigid;
  UpdateResult update;
};

/// Registers, then updates, with nothing told but the scan.
[[nodiscard]] TrialResult runTrial(const ReadyLiver& liver, const UpdateTrial& trial,
                                   const RegistrationSettings& registration,
                                   const UpdateSettings& settings = {});
/// Updates from a given start.
[[nodiscard]] TrialResult runTrialFrom(const ReadyLiver& liver, const UpdateTrial& trial,
                                       const Isometry3d& scanFromPreop, const UpdateSettings& settings = {});

/// No patches and no start: what a liver that nobody has painted needs.
[[nodiscard]] RegistrationSettings withoutPatches();

/// A turn about the origin drawn evenly, and a shift of up to `reachMm` along each axis.
[[nodiscard]] Isometry3d drawnPose(std::uint64_t seed, double reachMm);

}  // namespace falciform::bench
