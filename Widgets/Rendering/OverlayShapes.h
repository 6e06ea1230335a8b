#pragma once
#include <vtkActor2D.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>

#include "Logic/Core/Types.h"

namespace falciform {

/// A place on the screen that holds when the window is resized: a share of the viewport plus pixels.
struct Anchor {
  double x = 0, y = 0;    ///< share of the viewport, (0, 0) bottom left
  double dx = 0, dy = 0;  ///< pixels from there, right and up
};

enum class AlignX { Left, Centre, Right };
enum class AlignY { Bottom, Centre, Top };

/// Text of `px` pixels height, colour in [0, 1].
[[nodiscard]] vtkSmartPointer<vtkTextActor> textAt(const Anchor& anchor, const std::string& text, int px,
                                                   const Vector3d& colour, AlignX x = AlignX::Left,
                                                   AlignY y = AlignY::Bottom);

/// A filled rectangle of fixed size, lower left corner at the anchor.
[[nodiscard]] vtkSmartPointer<vtkActor2D> rectangleAt(const Anchor& anchor, double widthPx, double heightPx,
                                                      const Vector3d& colour);

}  // namespace falciform
