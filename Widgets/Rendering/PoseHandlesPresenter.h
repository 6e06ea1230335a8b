#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>

#include "Logic/Core/Types.h"

namespace falciform {

/// One handle of a body in the scene: a ring turns it about an axis of the scene, an arrow shifts it along.
struct PoseHandle {
  bool turns = false;
  int axis = 0;  ///< 0 x, 1 y, 2 z of the scene

  bool operator==(const PoseHandle&) const = default;
};

/// A handle held at one of its points, mm in the scene.
struct PoseGrip {
  PoseHandle handle;
  Vector3d point;
};

/// Colour of an axis, in [0, 1]; the panel's buttons have the same.
[[nodiscard]] Vector3d axisColour(int axis);

/// Three rings and three arrows around a place of the scene, drawn over all else.
class PoseHandlesPresenter {
 public:
  /// `pixelRatio`: true pixels in one of the desktop's, for lines that are as wide on a dense screen.
  explicit PoseHandlesPresenter(vtkRenderer* renderer, double pixelRatio = 1);
  ~PoseHandlesPresenter();
  PoseHandlesPresenter(const PoseHandlesPresenter&) = delete;
  PoseHandlesPresenter& operator=(const PoseHandlesPresenter&) = delete;

  /// `centre` mm in the scene; `radiusMm` of the rings; arrows stand outside them.
  void show(const Vector3d& centre, double radiusMm);
  /// Draws one handle wider, or none.
  void highlight(const std::optional<PoseHandle>& handle);

  /// The handle within 9 desktop pixels of a true pixel (origin bottom left), the nearest one.
  [[nodiscard]] std::optional<PoseGrip> at(double x, double y) const;
  /// N x 3 points of a handle as drawn, mm in the scene.
  [[nodiscard]] Points line(const PoseHandle& handle) const;

 private:
  struct Part {
    PoseHandle handle;
    vtkSmartPointer<vtkPolyData> data;
    vtkSmartPointer<vtkActor> actor;
  };
  vtkSmartPointer<vtkRenderer> renderer_;
  double pixelRatio_;
  std::array<Part, 6> parts_;
  Vector3d centre_ = Vector3d::Zero();
  double radiusMm_ = 0;
};

}  // namespace falciform
