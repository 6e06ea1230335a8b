#pragma once
#include "Logic/Core/Settings.h"

namespace falciform {

/// What a liver's mechanical model needs to know. The defaults are the thesis's.
struct LiverModelSettings {
  double edgeLengthMm = 12;
  double youngsModulusKPa = 15;
  double poissonsRatio = 0.47;
  double tumourModulusKPa = 60;
};

template <class Visitor>
void describe(LiverModelSettings& s, Visitor&& field) {
  field(FieldInfo{"edgeLengthMm", "Edge length", "mm", 4, 30,
                  "Mean edge of the elements; 12 mm make about 20,000 nodes of a liver, half of it eight "
                  "times as many."},
        s.edgeLengthMm);
  field(FieldInfo{"youngsModulusKPa", "Young's modulus", "kPa", 0.1, 10000,
                  "Stiffness of the liver; 2 to 15 kPa in health. Packing alone moves a stiff liver as far "
                  "as a soft one; gravity does not."},
        s.youngsModulusKPa);
  field(FieldInfo{"poissonsRatio", "Poisson's ratio", "", 0, 0.499,
                  "How little the tissue changes its volume; 0.5 would be not at all."},
        s.poissonsRatio);
  field(FieldInfo{"tumourModulusKPa", "Young's modulus of tumours", "kPa", 0.1, 10000,
                  "Stiffness of the structures whose name begins with 'tumour'."},
        s.tumourModulusKPa);
}

}  // namespace falciform
