#include "Logic/Registration/Trials/TrialMethod.h"

#include <algorithm>
#include <charconv>

#include "Logic/Core/Surface.h"

namespace falciform {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to == std::string::npos ? to : to - from));
    if (to == std::string::npos) return parts;
    from = to + 1;
  }
}

int parseLabel(const std::string& text, const std::string& whole) {
  int label = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), label);
  if (error != std::errc() || end != text.data() + text.size() || label < 1 || label > patch::kMax)
    throw InputError("method '" + whole + "' has the patch label '" + text +
                     "'; give whole numbers from 1 to 255 with + between, as in picp:1+2");
  return label;
}

}  // namespace

TrialMethod parseTrialMethod(const std::string& text) {
  TrialMethod method{text, registrationPreset("default")};
  std::string rest = text;
  if (const std::size_t slash = rest.find('/'); slash != std::string::npos) {
    method.settings = registrationPreset(rest.substr(0, slash));
    rest = rest.substr(slash + 1);
  }
  const std::size_t colon = rest.find(':');
  method.settings.method = enumFromString<RegistrationMethod>("method of the trials", rest.substr(0, colon));
  if (colon == std::string::npos) return method;
  if (method.settings.method == RegistrationMethod::Icp)
    throw InputError("method '" + text + "' names patches and icp uses none; leave them out");
  for (const std::string& label : split(rest.substr(colon + 1), '+'))
    method.settings.patches.push_back(parseLabel(label, text));
  return method;
}

std::vector<TrialMethod> parseTrialMethods(const std::string& text) {
  std::vector<TrialMethod> methods;
  for (const std::string& one : split(text, ',')) {
    methods.push_back(parseTrialMethod(one));
    if (std::count_if(methods.begin(), methods.end(), [&](const TrialMethod& m) { return m.name == one; }) >
        1)
      throw InputError("method '" + one + "' stands twice; name each once");
  }
  return methods;
}

}  // namespace falciform
