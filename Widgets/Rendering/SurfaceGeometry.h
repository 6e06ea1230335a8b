#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Surface.h"

namespace falciform {

/// Points, cells and unit normals for drawing. Normals are the surface's own, else of its triangles, else (a
/// cloud) fitted to each point's neighbours and turned towards the side that the cloud bulges to.
[[nodiscard]] vtkSmartPointer<vtkPolyData> displayGeometry(const Surface& surface);

/// Takes new points and normals for geometry that displayGeometry made of a surface with the same triangles:
/// for one that moves many times a second.
void moveGeometry(vtkPolyData* geometry, const Surface& surface);

/// Typical distance between neighbouring points, mm: the median over points of that to the fourth nearest,
/// which spans the gaps between a scanner's lines too; 0 for fewer than 5 points.
[[nodiscard]] double pointSpacing(const Points& points);

/// Whether both have the same points, triangles and given normals, so that only colours need to be drawn
/// anew.
[[nodiscard]] bool sameGeometry(const Surface& a, const Surface& b);

/// Whether both have as many points and the same triangles, at least one, so that one is the other moved.
[[nodiscard]] bool sameTriangles(const Surface& a, const Surface& b);

}  // namespace falciform
