#pragma once
#include <optional>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Registration/LabelledTarget.h"

namespace falciform {

/// Where a scan point meets a surface: three of its vertices and the share of each.
struct Counterpart {
  Eigen::Vector3i vertices = Eigen::Vector3i::Zero();
  Vector3d shares = Vector3d::UnitX();
};

/// N x 3: where counterparts lie on a surface with these points.
[[nodiscard]] Points placesOf(const std::vector<Counterpart>& counterparts, const Points& points);

/// Closest places of a surface that bends from one iteration to the next. The nearest vertex by Eq. (III.1),
/// then the closest place of the triangles around it: vertices alone would hold a scan fast in the gaps
/// between them. A place on triangles that all bear the label, where the vertex does.
class CounterpartSearch {
 public:
  /// `patches`: correspondences are biased by labels, by `correspondenceWeight` (w_PC). `surface` is copied.
  CounterpartSearch(const Surface& surface, bool patches, double correspondenceWeight = 1e-4);

  /// The surface's points as they are now. Nearest vertices may be those of a quarter of a millimetre ago;
  /// places on triangles are not.
  void moveTo(const Points& points);
  /// One for each of K points; `labels` K.
  [[nodiscard]] std::vector<Counterpart> find(const Points& points, const std::vector<int>& labels);
  /// Whether a label is one that correspondences are biased by.
  [[nodiscard]] bool uses(int label) const { return target_->has(label); }
  [[nodiscard]] const Points& points() const { return surface_.points; }

 private:
  [[nodiscard]] Counterpart around(const Vector3d& query, int vertex, int label) const;

  Surface surface_;
  std::vector<int> labels_;
  double correspondenceWeight_;
  Adjacency triangles_;
  std::optional<LabelledTarget> target_;
  std::vector<int> guesses_;
};

}  // namespace falciform
