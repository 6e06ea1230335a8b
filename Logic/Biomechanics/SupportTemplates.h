#pragma once
#include <array>

#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Biomechanics/SupportSolver.h"
#include "Logic/Core/Settings.h"

namespace falciform {

/// How a liver is commonly held and moved in open surgery.
enum class SupportTemplate { LeftLobePacked, RightLobePacked, TurnedLeft };

inline std::span<const std::string_view> enumNames(SupportTemplate) {
  static constexpr std::array<std::string_view, 3> names{"left-lobe-packed", "right-lobe-packed",
                                                         "turned-left"};
  return names;
}

inline constexpr double kUsualTurnDeg = 20;  ///< of an operating table

struct SupportTemplateSettings {
  SupportTemplate posture = SupportTemplate::LeftLobePacked;
  double pushMm = 20;    ///< the thesis's atlas goes from 5 to 45
  double extentMm = 25;  ///< radius of the packed place along the surface
  double turnDeg = 0;    ///< of the patient onto the left side; "turned left" takes 20 for 0
};

template <class Visitor>
void describe(SupportTemplateSettings& s, Visitor&& field) {
  field(FieldInfo{"posture", "Template", "", 0, 0, "How the liver is held and moved to begin with."},
        s.posture);
  field(FieldInfo{"pushMm", "Packing", "mm", 0, 45,
                  "How far the packing pushes the liver inwards, along the surface's normal."},
        s.pushMm);
  field(FieldInfo{"extentMm", "Extent", "mm", 5, 80, "Radius of the packed place, along the surface."},
        s.extentMm);
  field(FieldInfo{"turnDeg", "Turn to the left", "deg", -90, 90,
                  "Turns gravity as if patient and table were turned onto the left side since the CT."},
        s.turnDeg);
}

/// Vena cava fixed, posterior bed sliding, a place of radius `extentMm` in the middle of the left lobe's
/// underside pushed.
[[nodiscard]] std::vector<Support> leftLobePacked(const SupportSites& sites, double pushMm, double extentMm);

/// Vena cava fixed, a place in the middle of the right lobe's underside pushed; the lobe leaves its bed,
/// which is free.
[[nodiscard]] std::vector<Support> rightLobePacked(const SupportSites& sites, double pushMm, double extentMm);

/// Vena cava fixed, posterior bed sliding.
[[nodiscard]] std::vector<Support> lyingOnItsBack(const SupportSites& sites);

/// What gravity changes by, m/s2 in LPS, when a patient on the back is turned by `degrees` onto the left side
/// since the CT: from +y towards +x.
[[nodiscard]] Vector3d gravityChangeOfTurn(double degrees);

/// The template as one hypothesis. Throws InputError for settings out of range.
[[nodiscard]] SupportHypothesis supportTemplate(const SupportSites& sites,
                                                const SupportTemplateSettings& settings);

/// What a solver needs to know to answer for every template at once, for packing anywhere on the undersides,
/// and for bed and vena cava held or not.
[[nodiscard]] CandidateSupports candidatesOf(const SupportSites& sites);

}  // namespace falciform
