#pragma once
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// `count` rotations spread evenly over SO(3), the same at every call (super-Fibonacci spirals, Alexa 2022).
[[nodiscard]] std::vector<Matrix3d> rotationGrid(int count);

/// Poses worth refining, best first, one a basin (Docs/Decisions/PoseSearch.md): for each rotation of an even
/// grid the patches' centroids are brought together and the labelled points alone aligned; what differs by
/// more than 10 mm is then aligned with the surface and scored. Needs at least one label that both sides
/// have.
[[nodiscard]] std::vector<StartPose> startsFromPatches(const PreparedPreop& preop, const ScanSample& sample,
                                                       const Progress& progress = {});

/// The same with nothing painted: each rotation puts the scan against the side of the organ that it would
/// see, and the whole surface is aligned.
[[nodiscard]] std::vector<StartPose> startsFromSurface(const PreparedPreop& preop, const ScanSample& sample,
                                                       const Progress& progress = {});

/// Sorts best first and keeps of the poses in one basin (all of `places` within 10 mm of each other) the
/// best; at most `count`.
void keepDistinct(std::vector<StartPose>& poses, const Points& places, std::size_t count);

}  // namespace falciform
