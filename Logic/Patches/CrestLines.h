#pragma once
#include <vector>

#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Patches/CrestStrength.h"

namespace falciform {

/// Which crest lines are kept.
struct CrestLineSettings {
  double scaleMm = 8;       ///< radius of the fit of curvature
  double lowPerMm = 0.03;   ///< a line goes on while it is at least as sharp as this,
  double highPerMm = 0.06;  ///< if it is as sharp as this somewhere (hysteresis)
  double leastStrength =
      1;  ///< curvature summed along the line: radians of bending times its length over the radius
  double leastLengthMm = 15;
  double gapMm = 10;  ///< ends of two lines that run on into each other are joined over so much
};

template <class Visitor>
void describe(CrestLineSettings& s, Visitor&& field) {
  field(FieldInfo{"scaleMm", "Scale", "mm", 1, 50, "Radius of the fit of curvature."}, s.scaleMm);
  field(FieldInfo{"lowPerMm", "Low curvature", "1/mm", 0, 10, "A line goes on while it is as sharp."},
        s.lowPerMm);
  field(
      FieldInfo{"highPerMm", "High curvature", "1/mm", 0, 10, "A line is kept if it is as sharp somewhere."},
      s.highPerMm);
  field(FieldInfo{"leastStrength", "Least strength", "", 0, 1000, "Curvature summed along the line."},
        s.leastStrength);
  field(FieldInfo{"leastLengthMm", "Least length", "mm", 0, 1000, "Shorter lines are left out."},
        s.leastLengthMm);
  field(FieldInfo{"gapMm", "Longest gap", "mm", 0, 100,
                  "Ends of lines that run on into each other are joined."},
        s.gapMm);
}

struct CrestLine {
  Points points;       ///< N x 3, mm: where the line crosses the mesh's edges, in order
  VectorXd curvature;  ///< N, 1/mm, above 0
  double lengthMm = 0;
  double strength = 0;  ///< integral of the curvature along the line
};

/// Lines along which the curvature of `kind` is largest across the line (Monga, Benayoun 1995; traced over
/// edges as Ohtake, Belyaev, Seidel 2004 do), strongest first. Ambiguous triangles, where three lines would
/// meet, end a line. Throws InputError for a cloud, or settings out of range.
[[nodiscard]] std::vector<CrestLine> crestLines(const Surface& surface, CrestKind kind,
                                                const CrestLineSettings& settings = {});

}  // namespace falciform
