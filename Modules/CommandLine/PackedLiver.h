#pragma once
#include "Logic/Acquisition/SyntheticLiver.h"

namespace falciform::commandline {

/// Packing and turning of the built-in liver as an operation does it: by elasticity, not by a made-up field.
struct PackingSettings {
  double packingMm = 0;  ///< push under the left lobe; 0: none
  double packedExtentMm = 35;
  double packedEdgeLengthMm = 11;
};

template <class Visitor>
void describe(PackingSettings& s, Visitor&& field) {
  field(FieldInfo{"packingMm", "Packing", "mm", 0, 60,
                  "Push under the left lobe by a towel, computed elastically; above 0 it takes the place of "
                  "the smooth "
                  "deformation."},
        s.packingMm);
  field(FieldInfo{"packedExtentMm", "Packed extent", "mm", 5, 80,
                  "Radius of the packed place, along the surface."},
        s.packedExtentMm);
  field(FieldInfo{"packedEdgeLengthMm", "Edge length of packing", "mm", 4, 30,
                  "Mean edge of the elements that the packing is computed on; the time grows with the sixth "
                  "power of its inverse."},
        s.packedEdgeLengthMm);
}

/// The liver, its structures, targets and landmarks as packed: vena cava fixed, back on its sliding bed, left
/// lobe pushed; quadratic elements, turned truly (CorotationalWarp).
[[nodiscard]] SyntheticLiver packLiver(const SyntheticLiver& liver, const PackingSettings& settings,
                                       const Progress& progress = {});

}  // namespace falciform::commandline
