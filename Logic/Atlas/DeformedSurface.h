#pragma once
#include <utility>
#include <vector>

#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

/// Where all of the liver's nodes are under some loads, rigid motion apart.
struct BentNodes {
  Points displacements;  ///< N x 3 mm
  Points turns;          ///< N x 3 rotation vectors, radians
};
[[nodiscard]] BentNodes bendAll(const UpdateModel& model, const VectorXd& coefficients, bool trueTurns);

/// The place of a deformed surface nearest to a point.
struct SurfaceMeeting {
  int place = 0;                                                 ///< of the part: the vertex that is nearest
  Vector3d point = Vector3d::Zero(), normal = Vector3d::Zero();  ///< of the nearest place on triangles
  double distance = 0;
};

/// The pre-op surface as a model update has bent it so far, pre-op frame, for closest places: only the part
/// that the scan can reach is kept up to date. Inside Logic/Atlas only.
class DeformedSurface {
 public:
  DeformedSurface(const UpdateModel& model, const UpdateSettings& settings);

  /// Bends the whole liver and keeps from then on the part whose load centres lie within `reachMm` of the
  /// scan's points. Trees are made anew.
  void choose(const VectorXd& coefficients, const KdTree& scan, double reachMm);
  /// Bends the part that is kept. Trees stay as they are.
  void bend(const VectorXd& coefficients);
  /// Makes the trees of the part as it is now.
  void refreshTrees();

  /// Of the load centres where they are since choose(), C x 3.
  [[nodiscard]] const Points& centres() const { return centres_; }
  /// The nearest vertex by the trees' positions, and the nearest place of the triangles around it as they
  /// are.
  [[nodiscard]] SurfaceMeeting closest(const Vector3d& y) const;
  /// The same among a label's places; `patch` is a number in patches().
  [[nodiscard]] SurfaceMeeting closestOfPatch(std::size_t patch, const Vector3d& y) const;
  [[nodiscard]] const std::vector<std::pair<int, KdTree>>& patches() const { return patches_; }

  /// The vertex of fine() that a place of the part is.
  [[nodiscard]] int vertex(int place) const { return vertices_[static_cast<std::size_t>(place)]; }
  /// How tissue has turned there.
  [[nodiscard]] const Matrix3d& turn(int place) const { return turns_[static_cast<std::size_t>(place)]; }

 private:
  void keepPart(const std::vector<char>& nearCentre);
  void place();
  [[nodiscard]] SurfaceMeeting around(int nearest, const Vector3d& y, int label) const;

  const UpdateModel& model_;
  bool painted_;  ///< whether painted places will be asked for
  bool trueTurns_;
  Points linear_;  ///< N x 3 of small-strain theory, of which the rows in nodes_ are up to date
  Points centres_;
  std::vector<int> nodes_, vertices_;
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangles_;  ///< of places of the part
  std::vector<int> fanBegin_, fans_;                                  ///< triangles around each place
  Points points_, normals_;
  std::vector<Matrix3d> turns_;
  KdTree tree_;
  std::vector<std::pair<int, KdTree>> patches_;
};

}  // namespace falciform
