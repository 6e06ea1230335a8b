#pragma once
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"
#include "Logic/Geometry/RbfFunction.h"

namespace falciform {

struct RbfFitPlan {
  double noiseMm = 0;     ///< standard deviation of the points across the surface; 0: found from the points
  double finestMm = 0;    ///< step between the finest functions; 0: from the points' spacing
  double coarsestMm = 0;  ///< of the coarsest; 0: an eighth of the points' extent
  double cutoff = 3.4;    ///< waves shorter than so many steps are taken for noise by a level
};

/// One level of the fit.
struct RbfLevelReport {
  double stepMm = 0;
  Index functions = 0;
  int iterations = 0;
  bool converged = true;
  double rmsMm = 0;  ///< of the points' distances from the zero after this level
};

struct RbfFitResult {
  RbfFunction function;
  double noiseMm = 0;    ///< given or found
  double spacingMm = 0;  ///< between points
  std::vector<RbfLevelReport> levels;
  VectorXd residual;  ///< N, mm: of the points from the zero, positive outside
};

/// The function that is 0 at the points and grows along their normals, smoothed: radial basis functions on
/// lattices from coarse to fine (Floater and Iske 1996; Ohtake, Belyaev, Seidel 2003), each explaining what
/// the coarser ones left, with the third derivatives' energy held down (triharmonic smoothing: Carr et al.
/// 2003). A level's functions stand only where means of the residual are larger than the noise explains: so
/// what is smooth is smoothed over a wide range and what is sharp is followed. Normals say which side is
/// outside and need not be accurate. Throws InputError below 30 points, for coordinates that are not finite,
/// and for points in one place.
[[nodiscard]] RbfFitResult fitRbf(const Points& points, const Points& normals, const RbfFitPlan& plan,
                                  const Progress& progress = {});

}  // namespace falciform
