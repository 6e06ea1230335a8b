#pragma once
#include <QColor>
#include <QImage>
#include <QPointF>
#include <QRectF>
#include <functional>

#include "Logic/Core/Volume.h"
#include "Widgets/Views/SliceOptions.h"

namespace falciform {

/// Upright cuts through the patient: from the feet, from the front, from the left.
enum class SlicePlane { Axial, Coronal, Sagittal };

/// How a cut lies on the screen, in patient LPS, as radiologists look at it: the patient's right at the left
/// of the screen, front at the top of an axial cut, head at the top of the others.
struct SliceAxes {
  int through = 2;                   ///< the axis that is constant on the cut
  int across = 0, down = 1;          ///< axes along the screen,
  int acrossSign = 1, downSign = 1;  ///< and whether they grow to the right and downwards
  const char *left = "R", *right = "L", *top = "A", *bottom = "P";

  [[nodiscard]] QPointF onScreen(const Vector3d& mm) const {
    return {acrossSign * mm[across], downSign * mm[down]};
  }
  /// A place of the screen, mm, on the cut at `at`.
  [[nodiscard]] Vector3d inPatient(const QPointF& place, double at) const {
    Vector3d mm;
    mm[through] = at;
    mm[across] = acrossSign * place.x();
    mm[down] = downSign * place.y();
    return mm;
  }
};
[[nodiscard]] SliceAxes axesOf(SlicePlane plane);

/// The part `mm` (screen mm, see SliceAxes) of the cut at `at` in `pixels`, interpolated; outside of the
/// volume transparent.
[[nodiscard]] QImage sliceOf(const Image& ct, SlicePlane plane, double at, const QRectF& mm,
                             const QSize& pixels, const GreyWindow& window = {});
/// The same part of a label map, to be laid over it: each label's outline in its colour, its inside in the
/// same with the share `filled` of the opacity; background transparent; nearest voxel.
[[nodiscard]] QImage labelsOf(const LabelMap& labels, SlicePlane plane, double at, const QRectF& mm,
                              const QSize& pixels, const std::function<QColor(int)>& colour, double filled);
/// The same part of flags, hatched where they are above 0.
[[nodiscard]] QImage hatchOf(const LabelMap& flags, SlicePlane plane, double at, const QRectF& mm,
                             const QSize& pixels, const QColor& colour);

}  // namespace falciform
