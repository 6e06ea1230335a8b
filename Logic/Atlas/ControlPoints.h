#pragma once
#include "Logic/Atlas/AtlasModel.h"
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// What a few control points on the surface can do to the liver, in the manner of linearised iterative
/// boundary reconstruction (Heiselman et al. 2020).
struct ControlPointPlan {
  int controlPoints = 45;
  double radiusMm = 18;         ///< of the patch that each one moves
  double energyWeightMm2 = 50;  ///< mm^2 of squared residual that a strain energy of E V is worth
  int maxIterations = 60;
  double settledMm = 0.02;  ///< RMS change of the fitted surface under the scan by the last step
};

/// The modes of a floating liver moved at its control points along x, y and z, and their strain energy. Loads
/// and displacements of the same patches span the same fields, so surface loads serve. Throws as
/// solveSurfaceLoads does.
[[nodiscard]] std::shared_ptr<const Atlas> controlPointModes(const TetrahedralMesh& mesh,
                                                             const ControlPointPlan& plan = {},
                                                             const Progress& progress = {});
/// The same of loads that were solved for before.
[[nodiscard]] std::shared_ptr<const Atlas> controlPointModes(const LoadResponses& loads);

/// Rigid motion and modes at once, by Gauss-Newton: mean squared distance along the normal (painted points:
/// in all three directions) plus the strain energy at a fixed weight. Nothing is learnt, and no point is
/// doubted. Of the result as updateByClosestAtlas. Throws InputError for fewer than 10 usable scan points.
[[nodiscard]] UpdateResult updateByControlPoints(const AtlasModel& model, const Surface& scan,
                                                 const Isometry3d& scanFromPreopStart,
                                                 const ControlPointPlan& plan = {},
                                                 const UpdateSettings& settings = {}, std::uint64_t seed = 1,
                                                 const Progress& progress = {});

}  // namespace falciform
