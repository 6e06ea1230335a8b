#pragma once
#include <QString>

#include "Logic/Biomechanics/SupportLogic.h"

namespace falciform {

// What the page of supports says, apart from where it says it.

/// "22,002 nodes, 15,333 elements, mean edge 12 mm".
[[nodiscard]] QString modelWords(const SupportModel& model);
/// Of meshing and of the support sites.
[[nodiscard]] std::vector<std::string> modelWarnings(const SupportModel& model);
/// Whether there is a model, whether it is that of the settings, and what to do.
[[nodiscard]] QString modelState(const SupportLogic& logic);
/// Largest displacement and smallest det J.
[[nodiscard]] QString deformationWords(const DeformedLiver& liver);
/// Inverted elements, nearly flattened ones, supports too small to count.
[[nodiscard]] std::vector<std::string> deformationWarnings(const SupportLogic::Answer& answer);

}  // namespace falciform
