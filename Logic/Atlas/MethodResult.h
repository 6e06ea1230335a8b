#pragma once
#include <chrono>

#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Biomechanics/DenseAlgebra.h"

namespace falciform {

/// What every method says of the displacements it found: largest one, smallest det J, and warnings for folded
/// tissue and for a fit that did not settle. `result.displacements`, `converged` and `iterations` are filled.
void describeDeformation(const TetrahedralMesh& mesh, UpdateResult& result);

/// One update by any method: settings checked, BLAS kept to one thread so that results do not depend on how
/// many there are, wall time taken. `fit` returns the result.
template <class Fit>
[[nodiscard]] UpdateResult timedUpdate(const UpdateSettings& settings, Fit&& fit) {
  checkSettings(settings);
  const auto began = std::chrono::steady_clock::now();
  keepBlasSingleThreaded();
  UpdateResult result = fit();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return result;
}

}  // namespace falciform
