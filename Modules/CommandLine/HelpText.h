#pragma once
#include <string>

#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

/// Usage, and every argument with its unit, range, default and choices; wrapped at 100 columns.
[[nodiscard]] std::string helpText(const Syntax& syntax);

/// All commands, one line each.
[[nodiscard]] std::string overviewText();

}  // namespace falciform::commandline
