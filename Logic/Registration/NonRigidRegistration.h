#pragma once
#include <functional>

#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"
#include "Logic/Registration/ThinPlateSpline.h"

namespace falciform {

/// What a non-rigid method finds.
struct NonRigidResult {
  PatchIcpResult rigid;  ///< the rigid motion nearest to the warp over the pre-op surface, by area
  std::function<Points(const Points&)> scanFromPreopWarp;  ///< any pre-op points, mm, to scan mm
  Points warpedPreop;                                      ///< the pre-op surface's points, scan mm
};

/// ICP with a regularised thin-plate spline (Feldmar and Ayache 1996): a rigid ICP first, then closest points
/// and spline in turn while the stiffness falls, on a spread sample of the scan. The bend acts where the scan
/// is and dies away elsewhere. Patches are not looked at.
[[nodiscard]] NonRigidResult registerTpsIcp(const PreparedPreop& preop, const Surface& scan,
                                            const RegistrationSettings& settings,
                                            const Isometry3d& preopFromScanStart,
                                            const Progress& progress = {},
                                            const IterationObserver& observer = {});

/// Robust point matching with a thin-plate spline (TPS-RPM, Chui and Rangarajan 2003): every scan point
/// matches every pre-op point a little (softassign: rows and columns sum to 1, the rest is outlier), and
/// temperature and stiffness fall together. On samples of a few hundred points. Patches are not looked at.
[[nodiscard]] NonRigidResult registerRobustPoints(const PreparedPreop& preop, const Surface& scan,
                                                  const RegistrationSettings& settings,
                                                  const Isometry3d& preopFromScanStart,
                                                  const Progress& progress = {},
                                                  const IterationObserver& observer = {});

/// The result of pairs found: row i of `onPreop` is row i of `onScan` with weight i; `run` holds the history.
[[nodiscard]] NonRigidResult nonRigidFromPairs(const PreparedPreop& preop, const Points& onPreop,
                                               const Points& onScan, const VectorXd& weights,
                                               double stiffness, PatchIcpResult run);

/// Knots for a bend over `points`: spread evenly, the same at every call.
[[nodiscard]] Points knotsFor(const Points& points);

}  // namespace falciform
