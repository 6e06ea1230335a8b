#pragma once
#include <map>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/ClosestPointGrid.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

/// The pre-op surface as a search sees it: maps of closest points of the whole and of each label, and points
/// with normals packed side by side, in single precision (a search is good to a millimetre).
class CoarseTarget {
 public:
  CoarseTarget() = default;
  /// `normals`: N x 3 of the surface's points; every label of the surface gets its map.
  CoarseTarget(const Surface& preop, const Points& normals);

  struct Place {
    Eigen::Vector3f point, normal;
  };
  [[nodiscard]] const Place& closest(const Eigen::Vector3f& query) const {
    return places_[static_cast<std::size_t>(rowNear(query))];
  }
  /// Row of a point near `query`: a guess that spares an exact search much of its way.
  [[nodiscard]] int rowNear(const Eigen::Vector3f& query) const { return all_.closest(query); }
  [[nodiscard]] const Place& closestOf(int label, const Eigen::Vector3f& query) const {
    return places_[static_cast<std::size_t>(labels_.at(label).closest(query))];
  }

 private:
  std::vector<Place> places_;
  ClosestPointGrid all_;
  std::map<int, ClosestPointGrid> labels_;
};

/// A pose that a search may keep.
struct StartPose {
  Isometry3d preopFromScan = Isometry3d::Identity();
  double score = 0;  ///< robust residual in [0, 1], lower is better: mean of d^2 / (d^2 + (5 mm)^2), patch
                     ///< points counted threefold, a point whose normal faces the wrong way as a miss
  int starts = 1;    ///< how many starts ended here
};

/// How hard labelled points pull to their own label, against one that is not labelled: from `first` down to
/// `last` over half the iterations, by a constant factor each.
struct CoarsePull {
  double first = 0, last = 0;
  bool surface = true;  ///< false: labelled points to their labels alone
};

/// Rigid closest-point alignment for searches: point-to-plane with a little point-to-point, robust. Some ten
/// microseconds a step for a few hundred points. At most `iterations` steps; stops when nothing moves by
/// 0.3 mm and the pull has reached its last value.
void alignCoarsely(const CoarseTarget& target, const ScanSample& sample, const CoarsePull& pull,
                   int iterations, StartPose& pose);

/// Sets the score of `pose`.
void scoreCoarsely(const CoarseTarget& target, const ScanSample& sample, StartPose& pose);

}  // namespace falciform
