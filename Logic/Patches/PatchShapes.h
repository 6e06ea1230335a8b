#pragma once
#include <string>
#include <vector>

#include "Logic/Patches/BrushSurface.h"

namespace falciform {

/// What an operation on a whole patch would change: points it takes in, and points it gives up.
struct PatchChange {
  std::vector<int> gained, lost;  ///< ascending
  [[nodiscard]] bool empty() const { return gained.empty() && lost.empty(); }
};

// Of all these: `labels` holds one label a point of the surface; the answer is about the patch `label` alone,
// and whether a gained point may be taken from another patch is for the caller to say.

/// Takes in all points within `mm` of the patch, along the surface (straight on a cloud).
[[nodiscard]] PatchChange grownPatch(const BrushSurface& surface, const std::vector<int>& labels, int label,
                                     double mm);

/// Gives up all points within `mm` of what is outside of it. An open border of the surface is no outside.
[[nodiscard]] PatchChange shrunkPatch(const BrushSurface& surface, const std::vector<int>& labels, int label,
                                      double mm);

/// Rounds the border off: the patch is blurred over a standard deviation of about `mm`, by diffusion from
/// point to point near the border, and cut again where it keeps its area.
[[nodiscard]] PatchChange smoothedPatch(const BrushSurface& surface, const std::vector<int>& labels,
                                        int label, double mm);

/// Gives up all but the connected piece of the largest area (on a cloud: of most points).
[[nodiscard]] PatchChange largestPieceOfPatch(const BrushSurface& surface, const std::vector<int>& labels,
                                              int label);

/// Takes in holes: connected parts outside that are no larger than a quarter of the patch and touch no open
/// border. Larger ones may be the other side of a patch that runs all around; fill those by regionAt().
[[nodiscard]] PatchChange filledHoles(const BrushSurface& surface, const std::vector<int>& labels, int label);

/// All points that are connected to `point` over points of its own label, ascending.
[[nodiscard]] std::vector<int> regionAt(const BrushSurface& surface, const std::vector<int>& labels,
                                        int point);
/// Why a click should not fill `region`, in plain words; empty if it may. A region of more than half of the
/// surface is what a gap in the border leads to.
[[nodiscard]] std::string fillProblem(const BrushSurface& surface, const std::vector<int>& region);

}  // namespace falciform
