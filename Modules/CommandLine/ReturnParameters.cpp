#include "Modules/CommandLine/ReturnParameters.h"

namespace falciform::commandline {

std::string returnParameters(const std::vector<ResultField>& fields, const nlohmann::json& figures) {
  std::string text;
  for (const ResultField& field : fields)
    if (const auto found = figures.find(field.key); found != figures.end() && found->is_number())
      text += field.key + " = " + numberText(found->get<double>()) + "\n";
  return text;
}

}  // namespace falciform::commandline
