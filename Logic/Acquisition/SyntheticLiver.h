#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "Logic/Core/Landmarks.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// Size and shape of the built-in liver, so that a cohort can be drawn. Lengths in mm.
struct SyntheticLiverSettings {
  double widthMm = 210;         ///< right to left
  double depthMm = 150;         ///< front to back
  double heightMm = 160;        ///< foot to head, at the right lobe
  double leftLobeShare = 0.35;  ///< how far the left lobe reaches, as a share of the width
  double grooveDepthMm = 5;     ///< falciform groove
  double ridgeRadiusMm = 3;     ///< rounding of the inferior ridge; smaller is sharper
  double fossaDepthMm = 8;      ///< gallbladder fossa
  double domeShare = 1.0;       ///< height of the dome, 1 = as usual
  double variation = 0;  ///< share by which a seed varies all the above and adds low-frequency bumps; 0: none
  double edgeLengthMm = 1.3;  ///< of the surface; 1.3 gives about 60,000 vertices
  double voxelMm = 1.5;       ///< of the label map
  int seed = 1;
};

template <class Visitor>
void describe(SyntheticLiverSettings& s, Visitor&& field) {
  field(FieldInfo{"widthMm", "Width", "mm", 100, 400, "Right to left."}, s.widthMm);
  field(FieldInfo{"depthMm", "Depth", "mm", 60, 300, "Front to back."}, s.depthMm);
  field(FieldInfo{"heightMm", "Height", "mm", 60, 300, "Foot to head, at the right lobe."}, s.heightMm);
  field(FieldInfo{"leftLobeShare", "Left lobe", "", 0.2, 0.6,
                  "How far the left lobe reaches, as a share of the width."},
        s.leftLobeShare);
  field(FieldInfo{"grooveDepthMm", "Groove depth", "mm", 0, 15, "Depth of the falciform groove."},
        s.grooveDepthMm);
  field(FieldInfo{"ridgeRadiusMm", "Ridge radius", "mm", 1, 15, "Rounding of the inferior ridge."},
        s.ridgeRadiusMm);
  field(FieldInfo{"fossaDepthMm", "Fossa depth", "mm", 0, 20, "Depth of the gallbladder fossa."},
        s.fossaDepthMm);
  field(FieldInfo{"domeShare", "Dome", "", 0.6, 1.4, "Height of the dome, 1 = as usual."}, s.domeShare);
  field(FieldInfo{"variation", "Variation", "", 0, 0.3, "Share by which the seed varies the shape."},
        s.variation);
  field(FieldInfo{"edgeLengthMm", "Edge length", "mm", 0.8, 20, "Mean edge length of the surface."},
        s.edgeLengthMm);
  field(FieldInfo{"voxelMm", "Voxel", "mm", 0.7, 10, "Edge of the label map's voxels."}, s.voxelMm);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647,
                  "Draws the variation; the same seed gives the same liver."},
        s.seed);
}

/// Values in the synthetic label map.
namespace synthetic {
inline constexpr int kLiver = 1, kTumour = 2, kPortalVein = 3, kHepaticVein = 4;
}

struct SyntheticLiver {
  Surface surface;  ///< LPS mm, closed manifold, patches 1 and 2 painted
  std::map<std::string, Surface>
      structures;        ///< "tumour 1", "tumour 2", "portal vein", "hepatic vein": closed, inside
  Landmarks targets;     ///< points inside the liver (tumour centres, vessel branchings) for target error
  Landmarks anatomical;  ///< surface landmarks a surgeon can find: for landmark starts
};

/// An anatomically plausible liver (both lobes, dome, falciform groove, sharp inferior ridge, gallbladder
/// fossa) as the level set of a smooth implicit body. Deterministic by settings. Dimensions after literature
/// values.
[[nodiscard]] SyntheticLiver makeSyntheticLiver(const SyntheticLiverSettings& settings,
                                                const Progress& progress = {});

/// The same liver as a label map with the values of `synthetic`.
[[nodiscard]] LabelMap makeSyntheticLabelMap(const SyntheticLiverSettings& settings,
                                             const Progress& progress = {});

}  // namespace falciform
