#include "Logic/Atlas/ScanNext.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Core/Rotation.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {
namespace {

constexpr std::size_t kPlacesEach = 12;  ///< scan points beside a load centre that are worth one measurement

constexpr Index kPlacesOfLiver = 200;
constexpr double kSmoothMm = 10;  ///< about half of what parts load centres

/// A few vertices of the surface around each load centre, evenly among those that are nearest to it.
std::vector<std::vector<int>> placesAround(const UpdateModel& model) {
  std::vector<std::vector<int>> around(static_cast<std::size_t>(model.responses().centres.rows()));
  for (std::size_t v = 0; v < model.centreOf().size(); ++v)
    around[static_cast<std::size_t>(model.centreOf()[v])].push_back(static_cast<int>(v));
  for (std::vector<int>& vertices : around) {
    const std::size_t wanted = std::min(kPlacesEach, vertices.size());
    for (std::size_t i = 0; i < wanted; ++i) vertices[i] = vertices[i * vertices.size() / wanted];
    vertices.resize(wanted);
  }
  return around;
}

/// How the surface at the vertices moves along its own normal there.
Eigen::MatrixXd alongNormals(const UpdateModel& model, const UpdateResult& update,
                             const std::vector<int>& vertices, const Points& normals) {
  const Points places = model.fine().points(vertices, Eigen::all);
  const Eigen::MatrixXd rows = posteriorRows(model, update, places);
  const Points turns = MeshPlaces(model.locator(), places).interpolate(update.turns);
  Eigen::MatrixXd along(rows.rows(), places.rows());
  for (Index i = 0; i < places.rows(); ++i)
    along.col(i) =
        rows.middleCols<3>(3 * i) * (rotationOf(turns.row(i).transpose()) *
                                     normals.row(vertices[static_cast<std::size_t>(i)]).transpose());
  return along;
}

}  // namespace

VectorXd scanGainMm(const UpdateModel& model, const UpdateResult& update, const Points& preopMm) {
  if (preopMm.rows() == 0) throw InputError("there are no places whose expected error a scan could lessen");
  const double noise = std::max(update.noiseMm, 1.0), ofModel = modelErrorMm(update);
  const Eigen::MatrixXd targets = posteriorRows(model, update, preopMm);
  const Eigen::MatrixXd spread = product(update.covariance, targets);
  const auto expected = [&](const Eigen::RowVectorXd& variances) {
    const double mean = std::max(0.0, variances.sum()) / static_cast<double>(preopMm.rows());
    return std::hypot(kPosteriorScale * std::sqrt(mean), ofModel);
  };
  const Eigen::RowVectorXd variances = spread.cwiseProduct(targets).colwise().sum();
  const double before = expected(variances);
  const std::vector<std::vector<int>> around = placesAround(model);
  const Points normals = vertexNormals(model.fine());
  VectorXd gains = VectorXd::Zero(static_cast<Index>(around.size()));
  forEachChunk(around.size(), 4, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      if (around[c].empty()) continue;
      // Gaussian conditioning: what measurements along the normals leave of the targets' variance.
      const Eigen::MatrixXd seen = alongNormals(model, update, around[c], normals);
      Eigen::MatrixXd measured = seen.transpose() * update.covariance * seen;
      measured.diagonal().array() += noise * noise;
      const Eigen::MatrixXd shared = seen.transpose() * spread;
      const Eigen::MatrixXd half = measured.llt().matrixL().solve(shared);
      gains[static_cast<Index>(c)] = before - expected(variances - half.colwise().squaredNorm());
    }
  });
  return gains;
}

VectorXd scanGainOnSurface(const UpdateModel& model, const UpdateResult& update, const Points& targetsMm,
                           const Points& surfaceMm) {
  Points places = targetsMm;
  if (places.rows() == 0) {
    const Points& nodes = model.responses().mesh.points;
    std::vector<int> some;
    for (Index n = 0; n < nodes.rows(); n += std::max<Index>(1, nodes.rows() / kPlacesOfLiver))
      some.push_back(static_cast<int>(n));
    places = nodes(some, Eigen::all);
  }
  const VectorXd gains = scanGainMm(model, update, places);
  const Points& centres = model.responses().centres;
  VectorXd map(surfaceMm.rows());
  forEachChunk(static_cast<std::size_t>(map.size()), 256, [&](std::size_t first, std::size_t last) {
    for (auto i = static_cast<Index>(first); i < static_cast<Index>(last); ++i) {
      const VectorXd squares = (centres.rowwise() - surfaceMm.row(i)).rowwise().squaredNorm();
      // Beside the nearest centre's, so that nothing underflows far from all of them.
      const VectorXd shares = (-(squares.array() - squares.minCoeff()) / (2 * kSmoothMm * kSmoothMm)).exp();
      map[i] = shares.dot(gains) / shares.sum();
    }
  });
  return map;
}

}  // namespace falciform
