#include "Logic/Atlas/ModelUpdate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "Logic/Atlas/ModelFit.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Subdivision.h"

namespace falciform {

UpdateModel::UpdateModel(const Surface& preop, LoadResponses responses)
    : preop_(preop), responses_(std::move(responses)), warp_(responses_.mesh) {
  checkSurface(preop, "the pre-operative surface");
  const MeshLocator locator(responses_.mesh);
  constexpr double kFineEdgeMm = 2.5;
  fine_ = subdividedTo(preop, kFineEdgeMm);
  places_ = MeshPlaces(locator, fine_.points);
  centres_ = MeshPlaces(locator, responses_.centres);
  const KdTree tree(responses_.centres);
  centreOf_.resize(static_cast<std::size_t>(fine_.size()));
  forEachChunk(centreOf_.size(), 1024, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      centreOf_[v] = tree.nearest(fine_.points.row(static_cast<Index>(v)).transpose()).index;
  });
}

UpdateResult updateModel(const UpdateModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
                         const UpdateSettings& settings, std::uint64_t seed, const Progress& progress,
                         const UpdateObserver& observer) {
  checkSettings(settings);
  const auto began = std::chrono::steady_clock::now();
  keepBlasSingleThreaded();
  UpdateResult result = ModelFit(model, scan, scanFromPreopStart, settings, seed).run(progress, observer);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return result;
}

Points scanFromPreop(const UpdateModel& model, const UpdateResult& update, const Points& preopMm) {
  const MeshPlaces places(model.responses().mesh, preopMm);
  return transformed(preopMm + Points(places.interpolate(update.displacements)), update.scanFromPreop);
}

/// The posterior takes the model for true and residuals for independent, so it is too sure of itself: on the
/// seven livers of Docs/ModelUpdate.md true errors are twice as large on average.
constexpr double kInflation = 2;

VectorXd expectedErrorMm(const UpdateModel& model, const UpdateResult& update, const Points& preopMm) {
  const LoadResponses& loads = model.responses();
  const MeshPlaces places(loads.mesh, preopMm);
  const Points turns = places.interpolate(update.turns);
  const Points moved = preopMm + Points(places.interpolate(update.displacements));
  VectorXd errors(preopMm.rows());
  constexpr Index kTogether = 256;
  for (Index first = 0; first < preopMm.rows(); first += kTogether) {
    const Index count = std::min(kTogether, preopMm.rows() - first);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(loads.loads() + 6, 3 * count);
    forEachChunk(static_cast<std::size_t>(count), 8, [&](std::size_t from, std::size_t to) {
      for (auto i = static_cast<Index>(from); i < static_cast<Index>(to); ++i) {
        auto own = rows.middleCols(3 * i, 3);
        for (Index k = 0; k < places.nodes().cols(); ++k)
          own.topRows(loads.loads()) +=
              places.weights()(first + i, k) *
              loads.responses.middleCols(3 * static_cast<Index>(places.nodes()(first + i, k)), 3)
                  .cast<double>();
        own.topRows(loads.loads()).array().colwise() *= update.coefficientScale.array();
        own.topRows(loads.loads()) *= rotationOf(turns.row(first + i).transpose()).transpose();
        // A place errs against the scan by its own displacement less what turn and shift do to the scan.
        const Vector3d arm = moved.row(first + i).transpose() - update.turnCentre;
        for (Index a = 0; a < 3; ++a) {
          own.block<3, 1>(loads.loads(), a) = -arm.cross(Vector3d::Unit(a));
          own.block<3, 1>(loads.loads() + 3, a) = -Vector3d::Unit(a);
        }
      }
    });
    const Eigen::RowVectorXd variances = product(update.covariance, rows).cwiseProduct(rows).colwise().sum();
    for (Index i = 0; i < count; ++i)
      errors[first + i] = kInflation * std::sqrt(variances.segment<3>(3 * i).sum());
  }
  return errors;
}

}  // namespace falciform
