#pragma once
#include <string>
#include <vector>

#include "Logic/Atlas/Atlas.h"
#include "Logic/Core/Landmarks.h"
#include "Testing/Benchmarks/UpdateTrial.h"

namespace falciform::bench {

/// The phantom with a towel under one lobe.
struct PackedPhantom {
  std::string packing;        ///< "left", "right"
  UpdateTrial full, partial;  ///< all of the CT surface, what the scanner sees of it; places are the beads
  ErrorFigures before;        ///< how far the beads have moved in the frame of the spheres
  double coverage = 0;        ///< of the partial surface
  double minDetJ = 1;         ///< of the truth
  double share = 1;           ///< of the wanted push, that the truth was found for
};

/// The phantom of thesis ch. V: silicone, a screw at the vena cava, 43 beads, a painted falciform stripe; the
/// thesis's atlas of 20 places by 9 pushes on it; two packings.
struct PackedPhantoms {
  Surface preop;
  Atlas atlas;
  Landmarks beads;
  std::vector<PackedPhantom> packings;
};

struct PackedPhantomPlan {
  double surfaceEdgeMm = 2.45;  ///< the fits subdivide what is coarser than 2.5
  double atlasEdgeMm = 10;
  double truthEdgeMm = 12;
  double leftPushMm = 32, rightPushMm = 36, extentMm = 33;
  bool calculix = true;  ///< else linear elasticity with turns made true (CorotationalWarp): seconds
};

/// The truth is none of the atlas's: CalculiX, neo-Hookean and large displacement, on a mesh of its own, and
/// towels that lie in the middle of a lobe's underside, 33 mm in radius, where the atlas has 20 places of 30.
/// Throws std::runtime_error where CalculiX is missing.
[[nodiscard]] PackedPhantoms packedPhantoms(const PackedPhantomPlan& plan = {});

}  // namespace falciform::bench
