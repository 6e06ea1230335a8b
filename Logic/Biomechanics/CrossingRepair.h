#pragma once
#include <functional>
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

/// Places of a surface free of crossings where a mesh that fills it would be of poor shape: where sheets
/// nearly touch.
using PoorPlaces = std::function<std::vector<Vector3d>(const Surface& surface)>;

/// Remeshes a closed surface to `edgeLengthMm`. Where that makes it cut through itself (in clefts and rims
/// narrower than the edges), edges are made finer there; where that does not help, or the surface itself cuts
/// through itself, clefts are closed and threads cut by ever larger balls, up to a radius of `maxRepairMm`.
/// Then edges are made finer at `poorPlaces`, if given, as long as these become fewer.
[[nodiscard]] MeshableSurface meshableSurface(const Surface& surface, double edgeLengthMm, double maxRepairMm,
                                              const PoorPlaces& poorPlaces = {},
                                              const Progress& progress = {});

}  // namespace falciform
