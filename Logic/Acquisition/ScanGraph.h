#pragma once
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

/// Which points of a scan are taken for neighbours: joined by an edge of a mesh, or, of a cloud, among each
/// other's eight nearest and no farther apart than three usual spacings.
[[nodiscard]] Adjacency scanNeighbours(const Surface& scan);

/// Median distance of neighbours, mm; 0 if there are none.
[[nodiscard]] double usualSpacing(const Surface& scan, const Adjacency& neighbours);

/// Distance of each point from the nearest one with `sources`, mm along edges through points with `allowed`
/// (sources included); `limit` where it is farther or cannot be reached.
[[nodiscard]] std::vector<double> distancesAlong(const Surface& scan, const Adjacency& neighbours,
                                                 const std::vector<char>& sources,
                                                 const std::vector<char>& allowed, double limit);

/// The connected pieces of the points with `in`.
struct ScanPieces {
  std::vector<int> of;          ///< by point: its piece, -1 outside
  std::vector<double> areaMm2;  ///< by piece: of its triangles; of a cloud the number of its points

  /// The piece with the largest area, -1 if there is none.
  [[nodiscard]] int largest() const;
};
[[nodiscard]] ScanPieces scanPieces(const Surface& scan, const Adjacency& neighbours,
                                    const std::vector<char>& in);

}  // namespace falciform
