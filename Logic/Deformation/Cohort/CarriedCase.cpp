#include "Logic/Deformation/Cohort/CarriedCase.h"

#include <limits>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/Normalisation/SurfaceErrors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {
namespace {

constexpr double kNoWeight = 1e-9;  // a corner of no more need not be covered

}  // namespace

Eigen::MatrixXd valuesAt(const Surface& surface, const Eigen::MatrixXd& values, const Points& places,
                         double reachMm) {
  if (values.rows() != surface.size())
    throw InputError("there are values for " + std::to_string(values.rows()) + " vertices of a surface of " +
                     std::to_string(surface.size()) + "; give one each");
  const TriangleTree tree(surface);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd carried = Eigen::MatrixXd::Constant(places.rows(), values.cols(), kNone);
  forEachChunk(static_cast<std::size_t>(places.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) {
      const ClosestPlace place = tree.closest(places.row(i).transpose(), reachMm);
      if (place.triangle < 0) continue;
      carried.row(i).setZero();
      for (int k = 0; k < 3; ++k)
        if (place.barycentric[k] > kNoWeight)
          carried.row(i) += place.barycentric[k] * values.row(tree.vertexOf(place.triangle, k));
    }
  });
  return carried;
}

CarriedCase carryCase(const Surface& target, const Surface& source, const Eigen::MatrixXd& values,
                      const NormalisationSettings& settings, const Progress& progress) {
  const LiverMap map = registerLivers(target, source, settings, progress.part(0, 0.9));
  progress.report(0.9, "Carrying the maps over");
  SurfaceErrors errors = surfaceErrors(target, source, map);
  CarriedCase carried;
  carried.values = valuesAt(source, values, map.toSource(target.points), kCounterpartMm);
  carried.sourceToTarget = std::move(errors.sourceToTarget);
  carried.targetToSource = std::move(errors.targetToSource);
  carried.leastDeterminant = map.determinants(target.points).minCoeff();
  return carried;
}

VectorXd normalDisplacement(const Surface& surface, const Points& moved) {
  const Isometry3d back = fitRigid(moved, surface.points, vertexAreas(surface));
  const Points way = transformed(moved, back) - surface.points;
  return way.cwiseProduct(vertexNormals(surface)).rowwise().sum();
}

}  // namespace falciform
