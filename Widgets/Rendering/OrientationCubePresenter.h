#pragma once
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "Logic/Core/Types.h"

namespace falciform {

/// A cube at the lower right that turns with the view; its faces say which way the patient lies: R, L, A, P,
/// S, I.
class OrientationCubePresenter {
 public:
  /// Follows the camera of `view`.
  explicit OrientationCubePresenter(vtkRenderer* view);
  ~OrientationCubePresenter();
  OrientationCubePresenter(const OrientationCubePresenter&) = delete;
  OrientationCubePresenter& operator=(const OrientationCubePresenter&) = delete;

  /// Scenes in patient coordinates need nothing; a scene in a scanner's frame gives the rotation from LPS to
  /// it.
  void setSceneFromLps(const Matrix3d& rotation);
  /// How far above the view's lower edge it stands, as a share of its height.
  void setBottom(double share);
  /// Hidden where the patient's directions are not known.
  void setVisible(bool visible);

  /// The cube's own renderer, in layer 1.
  [[nodiscard]] vtkRenderer* renderer() const { return cube_; }

 private:
  void follow();

  vtkSmartPointer<vtkRenderer> view_, cube_;
  vtkSmartPointer<vtkProp3D> actor_;
  Matrix3d sceneFromLps_ = Matrix3d::Identity();
  unsigned long observer_ = 0;
};

}  // namespace falciform
