#pragma once
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "Logic/Core/Types.h"

namespace falciform::bench {

enum class PackedLobe { Left, Right, Both };
inline constexpr std::array<std::string_view, 3> kPackedLobeNames{"left", "right", "both"};

/// A towel under one lobe.
struct Pack {
  double pushMm = 0;
  double extentMm = 0;      ///< radius along the surface
  double offCentre = 0;     ///< 0: middle of the lobe's underside, 1: at a place drawn anywhere on it
  double lean = 0;          ///< weight of the anterior direction beside the region's inward normal
  bool sticks = false;      ///< holds the tissue in all directions; else it may slide across the push
  std::uint64_t place = 0;  ///< stream of the draw of the place
};

/// How a range scanner looks at a deformed liver.
struct ScannerPlan {
  std::uint64_t seed = 0;
  double azimuthDeg = 0, elevationDeg = 0, distanceMm = 0;  ///< of the scanner
  double coverage = 0;                                      ///< aimed at
  double noiseMm = 0, outlierShare = 0;
  bool raster = false;  ///< keeps the raster's triangles; else a cloud
};

/// Everything that is drawn of one held-out case: a pure function of its seed.
struct TruthPlan : ScannerPlan {
  PackedLobe lobe = PackedLobe::Left;

  double liverKPa = 0, poissonsRatio = 0;
  double tumourFactor = 0;  ///< its stiffness in that of the liver
  double tumourRadiusMm = 0;

  std::array<Pack, 2> packs;       ///< left, right; a push of 0: none
  Vector3d gravityChangeMPerS2;    ///< since the CT, LPS
  double turnDeg = 0;              ///< of gravity
  double heldRadiusMm = 0;         ///< of the bare area, fixed
  double heldTowardsVenaCava = 0;  ///< its centre: 0 middle of the bed behind the right lobe, 1 vena cava
  bool venaCavaHeld = false, ligamentHeld = false;
};

[[nodiscard]] TruthPlan drawTruth(std::uint64_t seed, PackedLobe lobe);
[[nodiscard]] nlohmann::json toJson(const TruthPlan& plan);

}  // namespace falciform::bench
