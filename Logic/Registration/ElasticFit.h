#pragma once
#include <Eigen/Cholesky>
#include <functional>

#include "Logic/Core/Progress.h"
#include "Logic/Registration/ElasticModes.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// What is assumed of tissue and scan. Lengths mm.
struct ElasticFitPlan {
  double strain = 0.016;  ///< standard deviation of each mode's root mean strain
  double residualMm = 1;  ///< of a cell's mean residual: what the modes leave unexplained
  bool learn =
      false;          ///< strain and residual from the scan itself (evidence, MacKay 1992), from those values
  double cellMm = 7;  ///< residuals in one cell count as one observation: neighbours are not independent
  double robustScaleMm = 5;  ///< Welsch scale, never below 3 median residuals
  double patchWeight = 1;    ///< of the pull of a labelled point outside its label, against the surface's
  int maxIterations = 40;
  double motionToleranceMm = 0.01;
  int firstIteration = 1;                                                   ///< for the records
  ElasticModes::Coefficients bending = ElasticModes::Coefficients::Zero();  ///< to begin with
};

struct ElasticFitResult {
  PatchIcpResult pose;  ///< the rigid part: where the organ as a whole is
  ElasticModes::Coefficients bending =
      ElasticModes::Coefficients::Zero();  ///< scan place in preop frame = x + u(x)
  Eigen::LLT<ElasticModes::Energy>
      precision;     ///< factors of the inverse covariance of the coefficients, column-wise stacked
  double score = 0;  ///< robust residual in [0, 1] plus what the bending costs; lower is better
  double strain = 0, residualMm = 0;  ///< as given or learnt
};

/// The most probable rigid motion together with a smooth bending (maximum a posteriori; Gauss-Newton on
/// point-to-plane residuals, with Welsch weights; a labelled point whose nearest point has another label is
/// drawn to its own). Only the rigid part is the registration: it is that of the whole organ, not of what
/// happens to be seen. Needs preop.normals(). Deterministic for any number of threads.
[[nodiscard]] ElasticFitResult fitElastic(const PreparedPreop& preop, const LabelledSource& scan,
                                          const ElasticFitPlan& settings, const Isometry3d& preopFromScan,
                                          const Progress& progress = {},
                                          const IterationObserver& observer = {});

/// By how much the rigid pose may be off at a place of the pre-op frame, mm: the bending found there and its
/// standard deviation, root of the sum of squares. Holds what it needs.
[[nodiscard]] std::function<double(const Vector3d& preopMm)> expectedTargetError(const ElasticModes& modes,
                                                                                 const ElasticFitResult& fit);

/// Root of its mean square over the organ, mm.
[[nodiscard]] double expectedTargetErrorMean(const ElasticModes& modes, const ElasticFitResult& fit);

}  // namespace falciform
