#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// The plane between the liver's lobes: sagittal, through the falciform ligament's groove. On the front the
/// groove may slant by 30 degrees, but carried on to the underside that slant would give half of the right
/// lobe to the left.
struct GroovePlane {
  Vector3d point = Vector3d::Zero();    ///< mm, LPS
  Vector3d toLeft = Vector3d::UnitX();  ///< unit normal, to the patient's left
  bool painted = false;                 ///< from patch 1; else the middle of the liver's box

  /// mm, positive on the left lobe's side.
  [[nodiscard]] double leftOf(const Vector3d& p) const { return toLeft.dot(p - point); }
};

/// From the falciform patch (label 1) of a pre-operative surface in LPS; with fewer than 3 painted points
/// the sagittal plane through the middle of the bounding box. Throws
/// InputError for a surface without points.
[[nodiscard]] GroovePlane groovePlane(const Surface& preop);

}  // namespace falciform
