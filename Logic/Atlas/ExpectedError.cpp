#include "Logic/Atlas/ExpectedError.h"

#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"

namespace falciform {
namespace {

constexpr double kModelError = 0.9;  ///< mm, for an RMS displacement of 1 mm; it grows as the root of that

}  // namespace

double modelErrorMm(const UpdateResult& update) {
  return kModelError *
         std::pow(update.displacements.rowwise().squaredNorm().mean(), 0.25);  // root of the RMS
}

Eigen::MatrixXd posteriorRows(const UpdateModel& model, const UpdateResult& update, const Points& preopMm) {
  const LoadResponses& loads = model.responses();
  if (update.covariance.rows() != loads.loads() + 6)
    throw InputError("the update knows no covariance of its " + std::to_string(loads.loads()) +
                     " loads; expected errors need one");
  const MeshPlaces places(model.locator(), preopMm);
  const Points turns = places.interpolate(update.turns);
  const Points moved = preopMm + Points(places.interpolate(update.displacements));
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(loads.loads() + 6, 3 * preopMm.rows());
  forEachChunk(static_cast<std::size_t>(preopMm.rows()), 8, [&](std::size_t from, std::size_t to) {
    for (auto i = static_cast<Index>(from); i < static_cast<Index>(to); ++i) {
      auto own = rows.middleCols(3 * i, 3);
      for (Index k = 0; k < places.nodes().cols(); ++k)
        own.topRows(loads.loads()) +=
            places.weights()(i, k) *
            loads.responses.middleCols(3 * static_cast<Index>(places.nodes()(i, k)), 3).cast<double>();
      own.topRows(loads.loads()).array().colwise() *= update.coefficientScale.array();
      const Eigen::MatrixXd turned =
          own.topRows(loads.loads()) * rotationOf(turns.row(i).transpose()).transpose();
      own.topRows(loads.loads()) = turned;
      // A place errs against the scan by its own displacement less what turn and shift do to the scan.
      const Vector3d arm = moved.row(i).transpose() - update.turnCentre;
      for (Index a = 0; a < 3; ++a) {
        own.block<3, 1>(loads.loads(), a) = -arm.cross(Vector3d::Unit(a));
        own.block<3, 1>(loads.loads() + 3, a) = -Vector3d::Unit(a);
      }
    }
  });
  return rows;
}

VectorXd expectedErrorMm(const UpdateModel& model, const UpdateResult& update, const Points& preopMm) {
  const double ofModel = modelErrorMm(update);
  VectorXd errors(preopMm.rows());
  constexpr Index kTogether = 256;
  for (Index first = 0; first < preopMm.rows(); first += kTogether) {
    const Index count = std::min(kTogether, preopMm.rows() - first);
    const Eigen::MatrixXd rows = posteriorRows(model, update, preopMm.middleRows(first, count));
    const Eigen::RowVectorXd variances = product(update.covariance, rows).cwiseProduct(rows).colwise().sum();
    for (Index i = 0; i < count; ++i)
      errors[first + i] =
          std::hypot(kPosteriorScale * std::sqrt(std::max(0.0, variances.segment<3>(3 * i).sum())), ofModel);
  }
  return errors;
}

VectorXd expectedErrorOnSurface(const UpdateModel& model, const UpdateResult& update,
                                const Points& surfaceMm) {
  const VectorXd nodes = expectedErrorMm(model, update, model.responses().mesh.points);
  return MeshPlaces(model.locator(), surfaceMm).interpolate(nodes).col(0).cwiseMax(0);
}

}  // namespace falciform
