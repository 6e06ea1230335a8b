#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// How slices that lie in space become a regular grid. Inside Logic/IO only.
struct DicomStack {
  int count = 0;                                   ///< slices of the grid
  Matrix4d worldFromIndex = Matrix4d::Identity();  ///< LPS mm
  std::vector<std::size_t> order;  ///< of the places given, along the normal; of equal places the first only
  std::vector<double> index;       ///< where each of `order` lies in the grid: whole numbers unless resampled
  bool resampled = false;
  std::vector<std::string> warnings;
  std::string refusal;  ///< why no grid can be made; empty: one was
};

/// Sorts `positions` (of the first voxels, LPS mm) along the normal of the plane that `axes` span, and finds
/// the grid. The rule (Docs/UserGuide/Import.md): the spacing is the median of the distances between
/// neighbours; where all agree with it within 2 % or 0.02 mm, the slices are the grid. Otherwise the grid is
/// still regular and reaches from the first slice to the last, and what lies between two slices is
/// interpolated, with a warning that says where; refused where that would make up a stretch of more than
/// 10 mm or four spacings, or more than a fifth of all slices. Slices that are each shifted by the same step
/// (tilted gantry) make an oblique grid; slices that are shifted otherwise are refused.
[[nodiscard]] DicomStack stackSlices(const std::vector<Vector3d>& positions,
                                     const Eigen::Matrix<double, 3, 2>& axes,
                                     const Eigen::Vector2d& spacingMm);

/// The same for a segmentation, in which empty slices are left out: `betweenSlicesMm` apart if that is above
/// 0, else by the smallest distance. Equal places are all kept.
[[nodiscard]] DicomStack stackSegments(const std::vector<Vector3d>& positions,
                                       const Eigen::Matrix<double, 3, 2>& axes,
                                       const Eigen::Vector2d& spacingMm, double betweenSlicesMm);

/// Slices nearer to each other than this, mm, lie at the same place.
constexpr double kSamePlaceMm = 1e-3;

}  // namespace falciform
