#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Surface.h"

namespace falciform {

/// A copy with point arrays "Patch" (unsigned char), "Normals", "RGB", "TCoords" (not their image) and one
/// double array per analysis array; a cloud gets one vertex cell a point; field arrays SPACE (the frame) and
/// PatchNames.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toVtk(const Surface& surface);
/// The reverse: polygons and strips are cut into triangles; unknown one-component numeric point arrays become
/// analysis arrays.
[[nodiscard]] Surface fromVtk(vtkPolyData* data);

}  // namespace falciform
