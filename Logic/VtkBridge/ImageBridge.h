#pragma once
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Volume.h"

namespace falciform {

/// Copies with origin, spacing and direction matrix set from worldFromIndex, left-handed grids included; one
/// scalar array, "Label" or "Intensity". Throws InputError if the axes are not perpendicular (cosine above
/// 1e-4).
[[nodiscard]] vtkSmartPointer<vtkImageData> toVtk(const LabelMap& volume);
[[nodiscard]] vtkSmartPointer<vtkImageData> toVtk(const Image& volume);

}  // namespace falciform
