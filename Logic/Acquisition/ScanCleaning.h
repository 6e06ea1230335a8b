#pragma once
#include <vector>

#include "Logic/Acquisition/ScanGraph.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// Limits of what is taken for a false return.
struct CleaningPlan {
  double outlierSpread = 5;  ///< standard deviations off the plane of the neighbours; 0: off
  int outlierNeighbours = 16;
  double grazingDeg = 80;            ///< between normal and ray; 90: off
  double smallestPieceShare = 0.02;  ///< of the largest piece's area; 0: off
};

/// Which points of a scan are false returns, and of what kind: 1 where one is.
struct FalseReturns {
  std::vector<char> outlier, grazing, smallPiece;
};

/// Marks, one after the other, each among what the ones before left:
/// - outliers: points of a mesh in no triangle, which jumps in depth have cut off; points twice as far from
///   their neighbours as these are from theirs and as is usual in the scan, or six times as far; and points
///   off the plane of their neighbours by more than `outlierSpread` robust standard deviations of all such
///   distances;
/// - grazing: the surface turns away from `towardsScanner` (unit) by more than `grazingDeg`, where a scanner
///   sees flying pixels between two depths; for points with normals or triangles;
/// - pieces smaller than a share of the largest.
[[nodiscard]] FalseReturns findFalseReturns(const Surface& scan, const Adjacency& neighbours,
                                            const Vector3d& towardsScanner, const CleaningPlan& plan,
                                            const Progress& progress = {});

}  // namespace falciform
