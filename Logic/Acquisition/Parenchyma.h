#pragma once
#include <string>
#include <vector>

#include "Logic/Acquisition/ScanGraph.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// Limits of what belongs to one tissue.
struct ParenchymaPlan {
  double colourLimit = 3.5;       ///< standard deviations from the colour of the tissue clicked; 0: off
  double creaseDeg = 35;          ///< a valley sharper than this, over `creaseMm`, ends the tissue; 180: off
  double creaseMm = 6;            ///< mm
  double bridgeMm = 5;            ///< what hangs on a bridge narrower than this is cut off; 0: off
  double closeMm = 12;            ///< clefts and strips of other colour narrower than this are taken in
  double largestHoleShare = 0.1;  ///< of the region's area: enclosed parts up to this are taken in
};

/// The part of a scan that is liver.
struct Parenchyma {
  std::vector<char> in;    ///< one a point
  std::vector<int> seeds;  ///< the points grown from
  bool automatic = false;  ///< no seed was given, and the seed was found by its colour
  bool byColour = false;   ///< false: the scan has no colours, or they are not to count
  double areaMm2 = 0;
  std::vector<std::string> warnings;
};

/// Grows the liver over a scan from seeds: to neighbours whose colour, smoothed over a few points, is like
/// the one around a seed (Mahalanobis distance in CIE Lab, lightness counting less than hue since it falls
/// off with the light), and which no sharp valley parts from it, as where gauze, a retractor or another organ
/// lies on the liver. Each seed has a colour of its own: one on the falciform ligament or a pale spot brings
/// that in. Bridges are cut, holes and strips closed, and the piece with the seeds, else the largest, is
/// kept. Without seeds the largest part with liver's colours gives one. Only points with `allowed` are
/// entered. `seeds`: N x 3, mm, in the scan's frame, each no farther than 20 mm from an allowed point: throws
/// InputError otherwise, and if nothing in the scan looks like liver. Results do not depend on the number of
/// threads.
[[nodiscard]] Parenchyma findParenchyma(const Surface& scan, const Adjacency& neighbours,
                                        const std::vector<char>& allowed, const Points& seeds,
                                        const ParenchymaPlan& plan, const Progress& progress = {});

}  // namespace falciform
