#pragma once
#include <vtkInteractorStyleTrackballCamera.h>

#include "Logic/Core/Types.h"

namespace falciform {

/// Mouse and keys that every 3D view has: left rotates, middle or Shift+left pans, right or the wheel zooms,
/// r fits all, capital A P R L S I are the standard views.
class NavigationInteractor : public vtkInteractorStyleTrackballCamera {
 public:
  static NavigationInteractor* New();
  vtkTypeMacro(NavigationInteractor, vtkInteractorStyleTrackballCamera);
  NavigationInteractor(const NavigationInteractor&) = delete;
  NavigationInteractor& operator=(const NavigationInteractor&) = delete;

  /// Rotation from LPS to the scene, for the standard views.
  Matrix3d sceneFromLps = Matrix3d::Identity();

  void OnChar() override;

 protected:
  NavigationInteractor() = default;
  ~NavigationInteractor() override = default;

  /// True if `key` was one of navigation's, and is done.
  bool navigate(char key);
  [[nodiscard]] bool modifierHeld() const;
};

}  // namespace falciform
