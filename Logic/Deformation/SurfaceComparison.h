#pragma once
#include <optional>

#include "Logic/Core/Surface.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/SurfaceBorder.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

/// What a place of one surface measures against the other; NaN where that does not cover it.
struct PlaceMeasured {
  double distanceMm = std::numeric_limits<double>::quiet_NaN();  ///< + where the scan lies outside
  double curvatureDifferencePerMm = std::numeric_limits<double>::quiet_NaN();  ///< scan less pre-op
  double segment = 0;  ///< of the pre-op surface there; also where it is not covered, but in reach
};

/// Two surfaces in one frame, made ready to be asked from either side, by any number of threads.
class SurfaceComparison {
 public:
  /// Both surfaces must outlive this.
  SurfaceComparison(const Surface& preop, const Surface& scan, const DistanceSettings& settings);

  /// Exact from the scan's point to the pre-op triangles.
  [[nodiscard]] PlaceMeasured atScanPoint(Index i) const;
  /// From the pre-op vertex to the scan's triangles, or its points if it is a cloud.
  [[nodiscard]] PlaceMeasured atPreopVertex(Index i) const;

  /// Mean curvature of each side, 1/mm; empty if the curvature radius is 0.
  [[nodiscard]] const VectorXd& preopCurvature() const { return preopCurvature_; }
  [[nodiscard]] const VectorXd& scanCurvature() const { return scanCurvature_; }

 private:
  [[nodiscard]] bool opposed(const Vector3d& a, const Vector3d& b) const;
  [[nodiscard]] PlaceMeasured toTriangles(Index i) const;
  [[nodiscard]] PlaceMeasured toPoints(Index i) const;
  [[nodiscard]] Vector3d cloudNormal(int point, const ClosestPlace& back) const;
  [[nodiscard]] double segmentAt(const ClosestPlace& place) const;
  void measureCurvature(double radiusMm);

  const Surface& preop_;
  const Surface& scan_;
  double reach_, leastCosine_;
  Points preopNormals_, scanNormals_;  ///< of the scan as measured, else of its triangles, else none
  TriangleTree preopTree_;
  SurfaceBorder preopBorder_;
  const VectorXd* segments_ = nullptr;  ///< of the pre-op vertices, if they are known
  std::optional<TriangleTree> scanTree_;
  std::optional<SurfaceBorder> scanBorder_;
  KdTree scanCloud_;
  std::optional<CloudBorder> cloudBorder_;
  VectorXd preopCurvature_, scanCurvature_;
};

}  // namespace falciform
