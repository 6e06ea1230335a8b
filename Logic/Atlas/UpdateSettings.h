#pragma once
#include "Logic/Core/Settings.h"

namespace falciform {

/// How a deformation model is fitted to a scan.
struct UpdateSettings {
  int maxIterations = 40;
  int samplePoints = 2500;         ///< of the scan in the last iterations; fewer before
  double effectiveSamples = 1000;  ///< how many independent measurements the scan is worth at most
  double noiseFloorMm = 0.3;       ///< least noise that is believed
  double patchWeight = 8;          ///< of a patch point's pull towards the same patch
  double loadFreedom = 6;          ///< of Student's t, which each place's loads follow beforehand
  bool trueTurns = true;           ///< large turns are made true ones; false: small-strain theory as it is
  double maxBendMm = 40;           ///< largest RMS bending that is believed beforehand
  double seenLoadShare = 0.03;     ///< loads where the scan sees the surface, beside those where it does not
  double reachMm = 15;             ///< how near scan points must be for a place to count as seen
};

template <class Visitor>
void describe(UpdateSettings& s, Visitor&& field) {
  field(FieldInfo{"maxIterations", "Iterations", "", 1, 1000, "The fit stops there if it has not settled."},
        s.maxIterations);
  field(FieldInfo{"samplePoints", "Scan points", "", 100, 100000, "Scan points used in the last iterations."},
        s.samplePoints);
  field(FieldInfo{"effectiveSamples", "Effective samples", "", 10, 1e6,
                  "How many independent measurements the whole scan is worth at most. How far neighbouring "
                  "points err "
                  "together, which makes it worth less, is learnt from the residuals."},
        s.effectiveSamples);
  field(FieldInfo{"noiseFloorMm", "Noise floor", "mm", 0.01, 10,
                  "The fit never believes the scan to be more exact."},
        s.noiseFloorMm);
  field(FieldInfo{"patchWeight", "Patch weight", "", 0, 100,
                  "Pull of a painted point towards the same patch; 0 leaves patches out."},
        s.patchWeight);
  field(FieldInfo{"loadFreedom", "Freedom of loads", "", 1, 1000,
                  "Degrees of freedom of Student's t: small where few places press hard, large where all "
                  "press alike."},
        s.loadFreedom);
  field(
      FieldInfo{"trueTurns", "True turns", "", 0, 0,
                "Tissue turns as it does; without, it swells where it turns far, as in small-strain theory."},
      s.trueTurns);
  field(FieldInfo{"maxBendMm", "Largest bending", "mm", 1, 200,
                  "RMS displacement, rigid motion apart, that is believed beforehand at most."},
        s.maxBendMm);
  field(FieldInfo{"seenLoadShare", "Loads on seen surface", "", 0.0001, 1,
                  "Size of loads where the scan sees the surface, beside loads where it does not: nothing "
                  "presses where the scanner looks."},
        s.seenLoadShare);
  field(FieldInfo{"reachMm", "Reach", "mm", 1, 100,
                  "A place of the surface is seen if many scan points are within this distance."},
        s.reachMm);
}

}  // namespace falciform
