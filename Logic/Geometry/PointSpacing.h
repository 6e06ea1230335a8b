#pragma once
#include "Logic/Core/Types.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

/// Side of the square that one point of a surface stands for, mm: the median over up to 2,000 points, from
/// the disc that holds its twelve nearest. 0 if more than half of the points share their places.
[[nodiscard]] double pointSpacing(const Points& points, const KdTree& tree);

/// Standard deviation, mm, of the points across the surface through them: what is left over by quadrics
/// through each point's 60 nearest, the median over up to 2,000 points. Noise that neighbours share, such as
/// a voxel's steps, is not seen.
[[nodiscard]] double pointNoise(const Points& points, const KdTree& tree);

}  // namespace falciform
