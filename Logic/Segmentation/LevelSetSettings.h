#pragma once
#include "Logic/Core/Settings.h"

namespace falciform {

/// How an organ grows from its seeds.
struct LevelSetSettings {
  double tissueWidth = 3.2;    ///< spreads of the tissue's brightness that still are the organ
  double neckMm = 0;           ///< radius of the narrowest neck the front may pass; 0: found from the image
  double reachMm = 5;          ///< how far the level set may go beyond the first growth
  double curvature = 0.3;      ///< weight of the curvature, voxels
  double patienceMm = 1;       ///< way lost by being slow that stops the front
  double fillMm = 6;           ///< clefts and vessels narrower than twice this are filled after the growth
  double noiseMm = 1.2;        ///< Gaussian against the CT's noise
  double coarsestMm = 3.2;     ///< voxel of the first growth
  double leastVolumeMl = 400;  ///< a liver's; below it a warning
  double mostVolumeMl = 3500;  ///< a liver's; above it a warning
  bool takeEnclosed = true;    ///< darker bodies that the organ encloses for the most part become organ
  bool fillCavities = true;    ///< background that the organ encloses becomes organ
};

template <class Visitor>
void describe(LevelSetSettings& s, Visitor&& field) {
  field(FieldInfo{"tissueWidth", "Tissue width", "", 0.5, 6,
                  "Standard deviations from the tissue's brightness that still are the organ."},
        s.tissueWidth);
  field(FieldInfo{"neckMm", "Narrowest neck", "mm", 0, 30,
                  "Radius of the narrowest neck that the front may pass; 0 finds it from the image."},
        s.neckMm);
  field(FieldInfo{"reachMm", "Reach", "mm", 0, 20, "How far the level set may go beyond the first growth."},
        s.reachMm);
  field(FieldInfo{"curvature", "Curvature", "voxels", 0, 1, "Weight of the curvature; more is smoother."},
        s.curvature);
  field(FieldInfo{"patienceMm", "Patience", "mm", 0.1, 50,
                  "Way that the front may lose by being slow before it stops."},
        s.patienceMm);
  field(FieldInfo{"fillMm", "Fill", "mm", 0, 20,
                  "After the first growth, clefts and vessels narrower than twice this are filled."},
        s.fillMm);
  field(FieldInfo{"noiseMm", "Noise filter", "mm", 0, 5, "Standard deviation of the Gaussian against noise."},
        s.noiseMm);
  field(FieldInfo{"coarsestMm", "Coarsest voxel", "mm", 1, 8, "Voxel of the first growth."}, s.coarsestMm);
  field(FieldInfo{"leastVolumeMl", "Least volume", "ml", 0, 100000, "A smaller organ is warned of."},
        s.leastVolumeMl);
  field(FieldInfo{"mostVolumeMl", "Most volume", "ml", 0, 100000, "A larger organ is warned of."},
        s.mostVolumeMl);
  field(
      FieldInfo{"takeEnclosed", "Take enclosed tissue in", "", 0, 1,
                "Take in darker bodies (20 HU or more) that the organ encloses for the most part: tumours."},
      s.takeEnclosed);
  field(FieldInfo{"fillCavities", "Fill cavities", "", 0, 1,
                  "Fill holes that the organ encloses on all sides."},
        s.fillCavities);
}

}  // namespace falciform
