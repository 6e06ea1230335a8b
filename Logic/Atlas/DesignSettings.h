#pragma once
#include <array>

#include "Logic/Core/Settings.h"

namespace falciform {

/// What an atlas varies.
enum class AtlasKind {
  GravityDirections,
  Packing,
  Sampled,
  SurfaceLoads  ///< no deformations, but answers to loads on the surface (LoadFiles.h)
};

inline std::span<const std::string_view> enumNames(AtlasKind) {
  static constexpr std::array<std::string_view, 4> names{"gravityDirections", "packing", "sampled",
                                                         "surfaceLoads"};
  return names;
}

/// The tissue of one region. The defaults are the thesis's liver.
struct TissueSettings {
  double youngsModulusKPa = 15;
  double poissonsRatio = 0.47;
  double densityKgPerM3 = 1000;
};

template <class Visitor>
void describe(TissueSettings& s, Visitor&& field) {
  field(FieldInfo{"youngsModulusKPa", "Young's modulus", "kPa", 0.01, 1e6, "Stiffness; liver: 2 to 15 kPa."},
        s.youngsModulusKPa);
  field(FieldInfo{"poissonsRatio", "Poisson's ratio", "", 0, 0.4999,
                  "0.5 is incompressible and cannot be computed; liver: 0.47 to 0.49."},
        s.poissonsRatio);
  field(FieldInfo{"densityKgPerM3", "Density", "kg/m3", 0, 20000, "Mass by volume; tissue: about 1000."},
        s.densityKgPerM3);
}

/// The thesis's first atlas: gravity turned about the y and z axes, one member each pair of angles.
struct GravityDesignSettings {
  double initialX = 0.7071, initialY = 0.7071, initialZ = 0;  ///< g0, at the CT: a direction
  double maxAngleDeg = 50;
  double stepDeg = 10;
  bool changeOnly = true;  ///< load rho (g - g0): the CT shows the liver under g0 already; false: rho g
};

template <class Visitor>
void describe(GravityDesignSettings& s, Visitor&& field) {
  field(FieldInfo{"initialX", "Gravity at the CT, x", "", -1, 1, "Direction, patient LPS: x to the left."},
        s.initialX);
  field(FieldInfo{"initialY", "Gravity at the CT, y", "", -1, 1, "Direction, patient LPS: y to the back."},
        s.initialY);
  field(FieldInfo{"initialZ", "Gravity at the CT, z", "", -1, 1, "Direction, patient LPS: z to the head."},
        s.initialZ);
  field(FieldInfo{"maxAngleDeg", "Largest turn", "deg", 0, 180, "About each of the y and z axes, both ways."},
        s.maxAngleDeg);
  field(FieldInfo{"stepDeg", "Step", "deg", 1, 180, "Between turns."}, s.stepDeg);
  field(
      FieldInfo{"changeOnly", "Load with the change of gravity", "", 0, 0,
                "The liver in the CT already bears gravity, so only its change deforms it; off: the whole of "
                "it, as the thesis prints."},
      s.changeOnly);
}

/// The thesis's second atlas: places on the underside pushed along their normal, by several distances each.
struct PackingDesignSettings {
  int places = 20;
  double extentMm = 30;
  double stepMm = 5;
  double maxPushMm = 45;
};

template <class Visitor>
void describe(PackingDesignSettings& s, Visitor&& field) {
  field(FieldInfo{"places", "Places", "", 1, 1000, "Packed places, spread evenly over the underside."},
        s.places);
  field(FieldInfo{"extentMm", "Extent", "mm", 5, 80, "Radius of a packed place, along the surface."},
        s.extentMm);
  field(FieldInfo{"stepMm", "Step", "mm", 0.1, 50, "Between pushes; the first push."}, s.stepMm);
  field(FieldInfo{"maxPushMm", "Largest push", "mm", 0.1, 100, "Into the liver, along the surface's normal."},
        s.maxPushMm);
}

/// Loads spread over the whole surface: what the model update fits.
struct SurfaceLoadSettings {
  int centres = 120;
  double radiusMm = 18;
};

template <class Visitor>
void describe(SurfaceLoadSettings& s, Visitor&& field) {
  field(FieldInfo{"centres", "Places", "", 4, 1000, "Spread evenly over the surface; three loads each."},
        s.centres);
  field(FieldInfo{"radiusMm", "Radius", "mm", 1, 100,
                  "Of a load: it falls off as a Gaussian of this width along each axis."},
        s.radiusMm);
}

/// Free ranges, sampled so that each is covered evenly: places by spreading, the rest by a Latin hypercube.
struct SampledDesignSettings {
  int members = 400;
  int setups = 100;
  double minExtentMm = 15, maxExtentMm = 50;
  double minPushMm = 0, maxPushMm = 45;
  double gravityX = 0, gravityY = 1, gravityZ = 0;  ///< at the CT: on the back
  double maxTurnDeg = 30;
  double minStiffnessRatio = 1, maxStiffnessRatio = 1;
  int stiffnessLevels = 1;
};

template <class Visitor>
void describe(SampledDesignSettings& s, Visitor&& field) {
  field(FieldInfo{"members", "Members", "", 1, 100000, "Deformations in all."}, s.members);
  field(FieldInfo{"setups", "Setups", "", 1, 10000,
                  "Different places, extents and support sets; members beyond four a setup cost nothing."},
        s.setups);
  field(FieldInfo{"minExtentMm", "Smallest extent", "mm", 5, 80, "Radius of a packed place."}, s.minExtentMm);
  field(FieldInfo{"maxExtentMm", "Largest extent", "mm", 5, 80, "Radius of a packed place."}, s.maxExtentMm);
  field(FieldInfo{"minPushMm", "Smallest push", "mm", -50, 100, "Height of the packing."}, s.minPushMm);
  field(FieldInfo{"maxPushMm", "Largest push", "mm", -50, 100, "Height of the packing."}, s.maxPushMm);
  field(FieldInfo{"gravityX", "Gravity at the CT, x", "", -1, 1, "Direction, patient LPS: x to the left."},
        s.gravityX);
  field(FieldInfo{"gravityY", "Gravity at the CT, y", "", -1, 1, "Direction, patient LPS: y to the back."},
        s.gravityY);
  field(FieldInfo{"gravityZ", "Gravity at the CT, z", "", -1, 1, "Direction, patient LPS: z to the head."},
        s.gravityZ);
  field(FieldInfo{"maxTurnDeg", "Largest turn of gravity", "deg", 0, 180,
                  "Gravity now lies anywhere within this angle of gravity at the CT."},
        s.maxTurnDeg);
  field(FieldInfo{"minStiffnessRatio", "Smallest stiffness ratio", "", 0.01, 1000,
                  "Young's modulus of tumours by that of the liver."},
        s.minStiffnessRatio);
  field(FieldInfo{"maxStiffnessRatio", "Largest stiffness ratio", "", 0.01, 1000,
                  "Young's modulus of tumours by that of the liver."},
        s.maxStiffnessRatio);
  field(FieldInfo{"stiffnessLevels", "Stiffness levels", "", 1, 100,
                  "Ratios between the two, evenly by their logarithm; each costs a factorisation."},
        s.stiffnessLevels);
}

}  // namespace falciform
