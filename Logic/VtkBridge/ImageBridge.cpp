#include "Logic/VtkBridge/ImageBridge.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkType.h>

#include <algorithm>
#include <type_traits>

#include "Logic/Core/Errors.h"

namespace falciform {

namespace {

/// Largest cosine between two axes that still counts as perpendicular: over a metre it is off by a tenth of a
/// millimetre, and a NIfTI header's float32 stays a thousand times below.
constexpr double kMostSkew = 1e-4;

/// Unit vectors of the index axes, as columns; left-handed if the grid is.
Matrix3d axesOf(const Matrix4d& worldFromIndex, const Vector3d& spacing) {
  Matrix3d axes = worldFromIndex.topLeftCorner<3, 3>();
  for (Index a = 0; a < 3; ++a) {
    if (!(spacing(a) > 0))
      throw InputError("the volume's spacing is " + std::to_string(spacing(a)) +
                       " mm along an axis; it must be above 0: export the volume again");
    axes.col(a) /= spacing(a);
  }
  const double skew = (axes.transpose() * axes - Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(skew <= kMostSkew))
    throw InputError("the volume's axes are not perpendicular (cosine " + std::to_string(skew) +
                     "); resample it to a perpendicular grid first");
  return axes;
}

template <class T>
vtkSmartPointer<vtkImageData> imageOf(const Volume<T>& volume) {
  const Vector3d spacing = volume.spacing();
  const Matrix3d axes = axesOf(volume.worldFromIndex, spacing);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(volume.size.x(), volume.size.y(), volume.size.z());
  image->SetSpacing(spacing.data());
  image->SetOrigin(volume.worldFromIndex(0, 3), volume.worldFromIndex(1, 3), volume.worldFromIndex(2, 3));
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> direction = axes;
  image->SetDirectionMatrix(direction.data());
  image->AllocateScalars(std::is_same_v<T, float> ? VTK_FLOAT : VTK_UNSIGNED_SHORT, 1);
  image->GetPointData()->GetScalars()->SetName(std::is_same_v<T, float> ? "Intensity" : "Label");
  std::copy(volume.voxels.begin(), volume.voxels.end(), static_cast<T*>(image->GetScalarPointer()));
  return image;
}

}  // namespace

vtkSmartPointer<vtkImageData> toVtk(const LabelMap& volume) { return imageOf(volume); }
vtkSmartPointer<vtkImageData> toVtk(const Image& volume) { return imageOf(volume); }

}  // namespace falciform
