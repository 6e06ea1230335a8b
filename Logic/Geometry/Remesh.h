#pragma once
#include <functional>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// Incremental isotropic remeshing (Botsch and Kobbelt 2004): splits, collapses (link condition kept), flips,
/// tangential relaxation and projection onto the input surface, `passes` times. A closed manifold stays one.
/// Point data except coordinates is dropped. `edgeLengthMm` > 0: the mean edge length aimed at.
/// Sharp ridges are held; boundary vertices of an open surface stay, and boundary edges are only cut. Closed
/// does not mean free of self-intersection: a cleft or tunnel narrower than the edges may be crossed. Throws
/// InputError if the surface is not an oriented manifold, or the edge length is not above 0 or would make
/// more than 20 million triangles.
[[nodiscard]] Surface remeshIsotropic(const Surface& surface, double edgeLengthMm, int passes = 6,
                                      const Progress& progress = {});

/// The edge length aimed at near a place, mm.
using EdgeLengthField = std::function<double(const Vector3d&)>;

/// The same with an edge length that varies from place to place: finer where a shape is narrow. The field
/// should be smooth (a slope below 1), above 0 and at least `shortestMm`.
[[nodiscard]] Surface remeshIsotropic(const Surface& surface, const EdgeLengthField& edgeLengthMm,
                                      double shortestMm, int passes = 6, const Progress& progress = {});

}  // namespace falciform
