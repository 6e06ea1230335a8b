#pragma once
#include <array>

#include "Logic/Core/Settings.h"

namespace falciform {

/// Linear tetrahedra lock where the tissue hardly changes its volume (METHODS 4.1); quadratic ones do not.
enum class ElementOrder { Linear, Quadratic };

inline std::span<const std::string_view> enumNames(ElementOrder) {
  static constexpr std::array<std::string_view, 2> names{"linear", "quadratic"};
  return names;
}

/// How a liver is filled with tetrahedra.
struct MeshSettings {
  double edgeLengthMm = 10;  ///< mean edge length aimed at, on the surface and inside
  ElementOrder order = ElementOrder::Quadratic;
  double tumourEdgeLengthMm = 0;  ///< 0: the liver's, or finer where a tumour is small
  double maxVolumeMm3 = 0;        ///< largest element; 0: about as fine inside as on the surface
  double radiusEdgeRatio = 1.414;
  double minDihedralDeg = 10;
  double maxRepairMm = 0;     ///< 0: half the edge length
  bool largestPiece = false;  ///< of a surface in several pieces
};

template <class Visitor>
void describe(MeshSettings& s, Visitor&& field) {
  field(FieldInfo{"edgeLengthMm", "Edge length", "mm", 2, 30,
                  "Mean edge length of the elements; 10 mm make about 20,000 of a liver."},
        s.edgeLengthMm);
  field(FieldInfo{"order", "Elements", "", 0, 0,
                  "Tetrahedra of 4 nodes (linear) or 10 (quadratic); linear ones are too stiff."},
        s.order);
  field(FieldInfo{"tumourEdgeLengthMm", "Edge length in tumours", "mm", 0, 30,
                  "Mean edge length of tumours; 0 takes the liver's, or less where a tumour is small."},
        s.tumourEdgeLengthMm);
  field(FieldInfo{"maxVolumeMm3", "Largest element", "mm3", 0, 20000,
                  "No element inside is larger; 0 ties it to the edge length."},
        s.maxVolumeMm3);
  field(FieldInfo{"radiusEdgeRatio", "Radius-edge ratio", "", 1.1, 3,
                  "Largest ratio of an element's circumscribed radius to its shortest edge; less is better "
                  "shaped and more elements."},
        s.radiusEdgeRatio);
  field(FieldInfo{"minDihedralDeg", "Smallest dihedral angle", "deg", 0, 16,
                  "Angle between two faces of an element that is aimed at."},
        s.minDihedralDeg);
  field(FieldInfo{"maxRepairMm", "Largest repair", "mm", 0, 20,
                  "Largest radius of the balls that close clefts; 0 is half the edge length."},
        s.maxRepairMm);
  field(FieldInfo{"largestPiece", "Largest piece only", "", 0, 1,
                  "Of a surface in several pieces take the largest; otherwise it is refused."},
        s.largestPiece);
}

}  // namespace falciform
