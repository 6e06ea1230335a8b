#include "Logic/Registration/RegistrationSettings.h"

namespace falciform {

namespace {

/// The thesis's values of ch. III; only the largest weight and its relaxation differ between its two
/// experiments.
RegistrationSettings thesis(double weightMax, double relaxation) {
  RegistrationSettings s;
  s.start = RegistrationStart::Given;
  s.finish = RegistrationFinish::None;
  s.weightMax = weightMax;
  s.weightBase = 25;
  s.relaxation = relaxation;
  s.robustScaleMm = 0;
  s.stop = StopRule::Rms;
  return s;
}

}  // namespace

RegistrationSettings registrationPreset(const std::string& name) {
  if (name == "default") return {};
  if (name == "thesis-phantom") return thesis(1000, 0.01);
  if (name == "thesis-clinical") return thesis(3000, 0.005);
  std::vector<std::string_view> names;
  const std::vector<std::string> all = registrationPresets();
  names.assign(all.begin(), all.end());
  throw InputError("preset is '" + name + "'; choose " + listOfNames(names));
}

std::vector<std::string> registrationPresets() { return {"default", "thesis-phantom", "thesis-clinical"}; }

}  // namespace falciform
