#pragma once
#include <QString>
#include <optional>

#include "Logic/Core/Case.h"
#include "Logic/Patches/PatchPaintingLogic.h"

namespace falciform {

/// What to do next with a case, from import to the updated model.
struct NextStep {
  QString words;                      ///< one short sentence
  QString module;                     ///< key of the module where it is done
  std::optional<PaintTarget> target;  ///< the surface to paint, where that is it
};
[[nodiscard]] NextStep nextStep(const Case& document);

}  // namespace falciform
