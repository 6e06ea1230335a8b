#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// Tissue that the front did not enter, because the way there is too narrow.
struct NarrowWay {
  double neckMm = 0;                  ///< radius of the widest ball that passes
  double volumeMl = 0;                ///< of what lies behind it
  Vector3d place = Vector3d::Zero();  ///< middle of what lies behind it, LPS mm
};

struct GrowthPlan {
  double neckMm = 0;       ///< radius of the narrowest neck that the front may pass; 0: found from the image
  double narrowestMm = 3;  ///< what is found is never below it
  double widestMm = 12;    ///< or above it
  double pieceShare = 0.02;  ///< one piece of this share of the volume behind one neck is not entered
  double tubeShare = 0.005;  ///< nor is a piece of this share that reaches far: a vessel
  double tubeReach = 3;      ///< "far", in neck radii
  double leastMl = 0;        ///< until the region has this, no piece is too large, as long as the whole
  double mostMl = 0;         ///< stays below this: the organ's plausible volume
  double leakShare = 0.08;   ///< when this share appears behind necks at once, the front gets no narrower
};

struct Growth {
  Volume<std::uint8_t> region;
  double neckMm = 0;            ///< of the front that made it
  double seedNeckMm = 0;        ///< narrowest place on the widest way between the seeds
  bool seedsApart = false;      ///< no way between some of them even for the narrowest front
  std::vector<NarrowWay> left;  ///< what was not entered, largest first
};

/// The first growth: a front leaves the seeds and runs where `open` is set. It remembers the narrowest place
/// that it has come through (the accumulated part of its speed) and stops for good where that falls below the
/// neck radius, however wide the tissue behind is. With no radius given, the front is wide at first and gets
/// narrower step by step. A large or far-reaching piece without a seed that appears behind one neck is not
/// entered and stays closed; when much appears at once, the front gets no narrower: so the organ's own shape
/// tells how narrow its necks are. `seeds` are voxels; one that is not open moves to the middle of the open
/// tissue nearby.
[[nodiscard]] Growth growFromSeeds(const Volume<std::uint8_t>& open, const std::vector<Vector3i>& seeds,
                                   const GrowthPlan& plan, const Progress& progress = {});

}  // namespace falciform
