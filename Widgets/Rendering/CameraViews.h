#pragma once
#include <vtkRenderer.h>

#include "Logic/Core/Types.h"

namespace falciform {

/// Where the viewer stands: Anterior looks at the patient from the front, Right from the patient's right.
enum class StandardView { Anterior, Posterior, Right, Left, Superior, Inferior };

/// Directions of a camera, unit vectors in the scene's frame.
struct ViewDirection {
  Vector3d from;  ///< from the scene towards the viewer
  Vector3d up;
};

/// In LPS. Superior and Inferior have the patient's front at the top.
[[nodiscard]] ViewDirection directionOf(StandardView view);

/// Turns the camera of a scene in LPS (or turned by `sceneFromLps`) and fits all that is visible.
void setStandardView(vtkRenderer* renderer, StandardView view,
                     const Matrix3d& sceneFromLps = Matrix3d::Identity());

/// Shares of the view that are kept free for titles, legends and bars.
struct ViewMargins {
  double left = 0.04, right = 0.04, bottom = 0.07, top = 0.04;
};

/// Puts the camera as near as it can be with all `points` inside the margins, for a view of `aspect` = width
/// / height.
void fitView(vtkRenderer* renderer, const Points& points, const ViewDirection& direction, double aspect,
             const ViewMargins& margins = {});

}  // namespace falciform
