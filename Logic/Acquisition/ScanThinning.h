#pragma once
#include <vector>

#include "Logic/Acquisition/ScanGraph.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// Points of the scan no two of which are nearer than `spacingMm` along it, and so many that none is farther
/// from one of them (Poisson disks, drawn by `seed`); ids ascending. What is finer than that is thinned, what
/// is coarser stays.
[[nodiscard]] std::vector<int> poissonDisks(const Surface& scan, const Adjacency& neighbours,
                                            double spacingMm, int seed);

/// The scan with these points alone, as they were measured; where three of their regions (the points nearest
/// to each along the scan) meet in a triangle, they are joined by one. Needs at least one id in every piece
/// that is to stay.
[[nodiscard]] Surface thinned(const Surface& scan, const Adjacency& neighbours, const std::vector<int>& ids);

}  // namespace falciform
