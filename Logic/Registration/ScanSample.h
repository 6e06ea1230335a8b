#pragma once
#include "Logic/Geometry/KdTree.h"
#include "Logic/Registration/LabelledSource.h"

namespace falciform {

/// A few hundred points that stand for the scan in a search, without its stragglers, with normals.
struct ScanSample {
  Points points;            ///< N x 3, mm, the scan's frame
  Points normals;           ///< N x 3 unit, all to one side
  std::vector<int> labels;  ///< N
  /// Whether `normals` are known to point out of the organ: a scan bulges to its outside, unless it is too
  /// flat or too hollow to tell.
  bool outward = true;

  [[nodiscard]] Index size() const { return points.rows(); }
};

/// The `rows` of `points` without stragglers: those whose neighbours are thrice as far as is usual (smoke,
/// threads, strewn noise). `tree` is over `points`.
[[nodiscard]] std::vector<int> withoutStragglers(const Points& points, const KdTree& tree,
                                                 const std::vector<int>& rows);

/// About `others` points of no label and at most `perLabel` of each label, without stragglers. `tree` is
/// over scan.points.
[[nodiscard]] ScanSample sampleScan(const LabelledSource& scan, const KdTree& tree, Index others,
                                    Index perLabel);

}  // namespace falciform
