#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "Logic/Atlas/SurfaceLoads.h"
#include "Logic/Atlas/UpdateSettings.h"
#include "Logic/Biomechanics/CornerWarp.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Results.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// The pre-operative side of a model update, made ready before the scan is there. Immutable.
class UpdateModel {
 public:
  /// `preop`: the surface that `responses.mesh` fills, same frame. Throws InputError as checkSurface does.
  UpdateModel(const Surface& preop, LoadResponses responses);

  [[nodiscard]] const Surface& preop() const { return preop_; }
  [[nodiscard]] const LoadResponses& responses() const { return responses_; }
  /// The pre-op surface, subdivided where its edges are long: closest points are sought among its points.
  [[nodiscard]] const Surface& fine() const { return fine_; }
  [[nodiscard]] const MeshPlaces& places() const { return places_; }    ///< of fine()'s points in the mesh
  [[nodiscard]] const MeshPlaces& centres() const { return centres_; }  ///< of the load centres
  /// Of each of fine()'s points: the nearest load centre.
  [[nodiscard]] const std::vector<int>& centreOf() const { return centreOf_; }
  /// Of responses().mesh: made once, since that takes longer than most questions it is asked.
  [[nodiscard]] const MeshLocator& locator() const { return locator_; }
  [[nodiscard]] const CornerWarp& warp() const { return warp_; }  ///< makes large turns true ones

 private:
  Surface preop_, fine_;
  LoadResponses responses_;
  CornerWarp warp_;
  MeshLocator locator_;
  MeshPlaces places_, centres_;
  std::vector<int> centreOf_;
};

/// Where the liver is now: pre-op places move by the mesh's displacements, then rigidly into the scan's
/// frame.
struct UpdateResult {
  Isometry3d scanFromPreop = Isometry3d::Identity();
  Points displacements;   ///< N x 3 at the mesh's nodes, pre-op frame, mm, rigid motion apart
  Points turns;           ///< N x 3 rotation vectors of tissue there, radians, rigid motion apart
  VectorXd coefficients;  ///< of the load responses
  /// Posterior covariance of (coefficients / coefficientScale, turn about `turnCentre`, shift): mm, radians.
  Eigen::MatrixXd covariance;
  VectorXd coefficientScale;
  Vector3d turnCentre = Vector3d::Zero();  ///< pre-op frame

  double rmsMm =
      0;  ///< point-to-plane residual of the scan's points, robustly weighted: fit, not target error
  double noiseMm = 0;              ///< as learnt from the residuals
  double effectiveSamples = 0;     ///< how many independent measurements the scan turned out to be worth
  double bendMm = 0;               ///< prior RMS bending as learnt by evidence
  double effectiveParameters = 0;  ///< how many of the loads the scan determines
  double minDetJ = 1;              ///< smallest local ratio of volumes; 0 or less: tissue folded over
  double largestMm = 0;            ///< largest displacement of a node, rigid motion apart
  int iterations = 0;
  bool converged = false;
  std::string stopReason;
  std::vector<std::string> warnings;
  double seconds = 0;
};

/// One iteration of a model update, for curves, and for whoever wants to end it here.
struct UpdateStep {
  int iteration = 0;                     ///< 1-based
  double rmsMm = 0;                      ///< as in UpdateResult, before the step
  double bendMm = 0;                     ///< as learnt so far
  double changeMm = 0;                   ///< RMS change of the fitted surface under the scan by this step
  std::function<UpdateResult()> result;  ///< as it stands after the step; valid during the call only
};

/// Called after each iteration, on the thread that updates; false ends the update with the result as it
/// stands.
using UpdateObserver = std::function<bool(const UpdateStep&)>;

/// Fits rigid motion and surface loads jointly to a scan (METHODS 5.3): maximum a posteriori, by Gauss-Newton
/// on robust point-to-plane distances to the deformed surface and on pulls between patches of one label;
/// loads are independent beforehand, small where the scan sees the surface, since nothing presses there; how
/// far the liver bends and how noisy the scan is are learnt by evidence (MacKay 1992). Supports need not be
/// known. `scanFromPreopStart`: a rigid registration. Throws InputError for fewer than 10 scan points.
[[nodiscard]] UpdateResult updateModel(const UpdateModel& model, const Surface& scan,
                                       const Isometry3d& scanFromPreopStart,
                                       const UpdateSettings& settings = {}, std::uint64_t seed = 1,
                                       const Progress& progress = {}, const UpdateObserver& observer = {});

/// Pre-op places (K x 3, mm) to where they are now, scan mm: targets, vessels, tumours. Beyond the mesh
/// displacements go on linearly.
[[nodiscard]] Points scanFromPreop(const UpdateModel& model, const UpdateResult& update,
                                   const Points& preopMm);

}  // namespace falciform
