#pragma once
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

class TriangleTree;

/// One value at each corner of a lattice of cubes, x fastest.
struct GridField {
  Vector3d origin = Vector3d::Zero();  ///< of corner (0, 0, 0), mm
  double cellMm = 1;
  Vector3i counts = Vector3i::Zero();  ///< corners along x, y, z
  std::vector<float> values;

  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(counts.x()) *
               (static_cast<std::size_t>(y) +
                static_cast<std::size_t>(counts.y()) * static_cast<std::size_t>(z));
  }
  [[nodiscard]] Vector3d place(int x, int y, int z) const { return origin + cellMm * Vector3d(x, y, z); }
};

/// Distance to a closed surface, mm, negative inside, cut off at +-`bandMm`, over the surface's box grown by
/// more than the band. Inside is where the winding number is 1 or more: where sheets overlap, both are
/// inside; pockets turned inside out are outside. `cellMm` is made larger where the lattice would exceed 20
/// million corners.
[[nodiscard]] GridField signedDistanceField(const Surface& surface, double cellMm, double bandMm);
/// The same with the surface's tree at hand, for several lattices of one surface.
[[nodiscard]] GridField signedDistanceField(const Surface& surface, const TriangleTree& tree, double cellMm,
                                            double bandMm);

/// The surface where the field, linear in tetrahedra (each cube cut into six), takes the value `level`:
/// a closed manifold that never cuts through itself, triangles facing larger values. Needs values above the
/// level all around the lattice's border. Small triangles of any shape: remesh it.
[[nodiscard]] Surface levelSurface(const GridField& field, double level);

/// The surface with clefts, tunnels and gaps narrower than 2 `closeMm` filled and then lobes, threads and
/// rims thinner than 2 `openMm` taken away: morphological closing and opening by balls. The result is nowhere
/// farther than the larger radius and a cell's share from the surface. Largest piece only; sheets that
/// overlapped are joined.
[[nodiscard]] Surface roundedSurface(const Surface& surface, double closeMm, double openMm, double cellMm);

}  // namespace falciform
