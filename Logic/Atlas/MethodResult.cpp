#include "Logic/Atlas/MethodResult.h"

#include <cmath>

#include "Logic/Biomechanics/DeformationCheck.h"

namespace falciform {

void describeDeformation(const TetrahedralMesh& mesh, UpdateResult& result) {
  result.minDetJ = checkDeformation(mesh, result.displacements).minDetJ;
  result.largestMm = std::sqrt(result.displacements.rowwise().squaredNorm().maxCoeff());
  if (!result.converged)
    result.warnings.push_back("the model had not settled after " + std::to_string(result.iterations) +
                              " iterations");
  if (!(result.minDetJ > 0))
    result.warnings.push_back(
        "the fitted deformation folds tissue over itself somewhere: do not trust it there");
}

}  // namespace falciform
