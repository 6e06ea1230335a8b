#pragma once
#include <chrono>

#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// What every method says of the displacements it found: largest one, smallest det J, and warnings for folded
/// tissue and for a fit that did not settle. `result.displacements`, `converged` and `iterations` are filled.
void describeDeformation(const TetrahedralMesh& mesh, UpdateResult& result);

/// Wall time since it was made.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  }

 private:
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace falciform
