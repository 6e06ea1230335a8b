#pragma once
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Volume.h"

namespace falciform {

/// Copies with origin, spacing and direction matrix set from worldFromIndex (a shear is refused).
[[nodiscard]] vtkSmartPointer<vtkImageData> toVtk(const LabelMap& volume);
[[nodiscard]] vtkSmartPointer<vtkImageData> toVtk(const Image& volume);

}  // namespace falciform
