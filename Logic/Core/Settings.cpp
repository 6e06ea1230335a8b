#include "Logic/Core/Settings.h"

#include <sstream>

namespace falciform {

std::string listOfNames(std::span<const std::string_view> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

void checkRange(const FieldInfo& info, double value) {
  if (value >= info.min && value <= info.max) return;  // false for NaN
  std::ostringstream message;
  message << info.key << " is " << value << (info.unit.empty() ? "" : " ") << info.unit
          << "; it must lie in [" << info.min << ", " << info.max << "]" << (info.unit.empty() ? "" : " ")
          << info.unit;
  throw InputError(message.str());
}

void refuseJson(const FieldInfo& info, const nlohmann::json& found, std::string_view expected) {
  throw InputError("setting " + std::string(info.key) + " is " + found.dump() + "; it must be " +
                   std::string(expected));
}

}  // namespace falciform
