#pragma once
#include <string>
#include <vector>

#include "Logic/Registration/RegistrationSettings.h"

namespace falciform {

/// One of the methods that a set of trials compares.
struct TrialMethod {
  std::string name;  ///< as it was asked for: "thesis-phantom/picp:1+2"
  RegistrationSettings settings;
};

/// Reads `[preset/]method[:label+label...]`: "icp", "picp:1", "thesis-phantom/picp:1+2". Throws InputError
/// that lists the presets or methods there are.
[[nodiscard]] TrialMethod parseTrialMethod(const std::string& text);
/// Several, with commas between. Throws InputError for none and for one that stands twice.
[[nodiscard]] std::vector<TrialMethod> parseTrialMethods(const std::string& text);

}  // namespace falciform
