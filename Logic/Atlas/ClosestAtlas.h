#pragma once
#include "Logic/Atlas/AtlasModel.h"
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// How coefficients are found once each scan point has its counterpart.
enum class AtlasSolve { Tikhonov, Constrained, Statistical };

/// One loop, three ways to solve: the iterative closest atlas of chapter V.
struct ClosestAtlasPlan {
  AtlasSolve solve = AtlasSolve::Tikhonov;
  bool patches = false;                  ///< correspondences biased by labels, Eq. (III.1)
  double weightMax = 1, weightBase = 1;  ///< w_PBR of Eq. (III.3), of points on patches
  double relaxation = 0.001;             ///< alpha of Eq. (III.3)
  double correspondenceWeight = 1e-4;    ///< w_PC of Eq. (III.1)
  double lambda = 0.01;                  ///< of Eq. (V.17); Tikhonov
  double varianceShare = 0.95;           ///< that the components hold; Statistical
  int maxIterations = 1000;
  double rmsToleranceMm = 1e-6;  ///< stop when the RMS residual changes by less
};

/// The thesis's ICAt (no patches) and ICAt* (w_max 2000, w_base 1, alpha 0.001), with its stop rule.
[[nodiscard]] ClosestAtlasPlan icatPlan();
[[nodiscard]] ClosestAtlasPlan icatStarPlan();
/// Constrained inverse and statistics in the same loop, with patches as a bias of correspondences only.
[[nodiscard]] ClosestAtlasPlan constrainedPlan();
[[nodiscard]] ClosestAtlasPlan pcaPlan();

/// Fits pose and atlas in turn (thesis ch. V, steps 1 to 6, errata applied: displacements and not positions,
/// weights on both sides, centred coordinates in d_err): closest points, rigid fit, closest points,
/// coefficients. `coefficients` of the result: of the atlas's members, or of the modes (Statistical); rmsMm:
/// distances to counterparts; no covariance, so no expected error. Throws InputError for fewer than 10 usable
/// scan points.
[[nodiscard]] UpdateResult updateByClosestAtlas(const AtlasModel& model, const Surface& scan,
                                                const Isometry3d& scanFromPreopStart,
                                                const ClosestAtlasPlan& plan,
                                                const UpdateSettings& settings = {}, std::uint64_t seed = 1,
                                                const Progress& progress = {});

}  // namespace falciform
