#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Crossings.h"

namespace falciform {

/// A surface of even triangles that can be filled with tetrahedra, and how it came about.
struct MeshableSurface {
  Surface surface;
  std::vector<Crossing> first;       ///< of the surface remeshed without repair
  std::vector<Crossing> left;        ///< that no repair mended; empty if all is well
  std::vector<std::string> repairs;  ///< in words
};

/// Remeshes a closed surface to `edgeLengthMm`. Where that makes it cut through itself (in clefts and rims
/// narrower than the edges), edges are made finer there; where that does not help, or the surface itself cuts
/// through itself, clefts are closed and threads cut by ever larger balls, up to a radius of `maxRepairMm`.
[[nodiscard]] MeshableSurface meshableSurface(const Surface& surface, double edgeLengthMm, double maxRepairMm,
                                              const Progress& progress = {});

}  // namespace falciform
