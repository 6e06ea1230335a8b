#pragma once
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform {

// VTK's surface algorithms as functions on Core types. This header names no VTK type.

/// The surface where `field` crosses `level`, in LPS mm, triangles facing the side of lower values (outwards
/// for a field that is larger inside), whatever the handedness of the grid. Marching cubes
/// (vtkFlyingEdges3D).
[[nodiscard]] Surface isosurface(const Image& field, double level);

/// Windowed-sinc smoothing (Taubin, Zhang, Golub 1996): `passBand` in (0, 2], lower is smoother. Topology
/// unchanged; boundary edges stay where they are; normals are dropped.
[[nodiscard]] Surface smoothWindowedSinc(const Surface& surface, int iterations, double passBand);

}  // namespace falciform
