#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Testing/Benchmarks/Truths/TruthPlan.h"

namespace falciform::bench {

/// What is done to a liver before it is scanned, and what thesis ch. IV saw of it.
enum class Procedure {
  LeftHepatectomy,  ///< group A: flattened, deepest about the falciform ligament and left of it
  Bilobar,          ///< group B: more curved, the middle above and both ends below
  RightLobe,        ///< group C: flattened, deepest in the right lobe
  TurnedLeft,       ///< of its own: the table turned to the left, the weight alone
  HeadUp            ///< of its own: the table turned head up, the weight alone
};
inline constexpr std::array<std::string_view, 5> kProcedureNames{"left hepatectomy", "bilobar", "right lobe",
                                                                 "turned left", "head up"};
/// "A", "B", "C", or empty for a procedure of its own.
[[nodiscard]] std::string groupOf(Procedure procedure);

/// How far the front is moved forwards, by what holds it from before and behind: a bump and a rim of the
/// other sign, and three waves that are the patient's own. Coordinates: u from -1 at the right end over 0 at
/// the falciform ligament to 1 at the left end; v from -1 below to 1 above.
struct FrontPattern {
  double centreU = 0, centreV = 0, widthU = 0, widthV = 0;
  double bumpMm = 0, rimMm = 0;  ///< in the middle of the bump, and far from it; forwards above 0
  struct Wave {
    double amplitudeMm = 0, u = 0, v = 0, phase = 0;
  };
  std::array<Wave, 3> waves;

  [[nodiscard]] double at(double u, double v) const;
};

/// Everything that is drawn of one case: a pure function of procedure and seed.
struct CohortPlan {
  Procedure procedure = Procedure::LeftHepatectomy;
  ScannerPlan scanner;  ///< its seed is the case's
  double liverKPa = 0;
  std::optional<FrontPattern> front;                ///< none: the front is free
  Vector3d gravityChangeMPerS2 = Vector3d::Zero();  ///< since the CT, LPS
  double heldRadiusMm = 0;                          ///< of the bare area, fixed
};

[[nodiscard]] CohortPlan drawCohortCase(Procedure procedure, std::uint64_t seed);
[[nodiscard]] nlohmann::json toJson(const CohortPlan& plan);

/// A case of the cohort: the livers of the real data dealt out to the procedures in the order of their
/// numbers, before any was looked at.
struct CohortMember {
  int liver = 0;
  Procedure procedure = Procedure::LeftHepatectomy;
};
[[nodiscard]] const std::vector<CohortMember>& cohortMembers();

}  // namespace falciform::bench
