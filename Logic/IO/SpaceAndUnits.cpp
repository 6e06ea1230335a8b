#include "Logic/IO/SpaceAndUnits.h"

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

constexpr double kAbsurdMm = 1e6;   ///< no operating theatre is a kilometre wide
constexpr double kMetresBelow = 1;  ///< a liver of 0.2 units is in metres
constexpr double kMicrometresAbove = 20'000;

}  // namespace

bool honourSpace(Points& points, std::string& frame, const std::optional<std::string>& space,
                 const std::string& name, std::vector<std::string>& warnings) {
  frame = space.value_or("LPS");
  if (!space)
    warnings.push_back(
        name + " does not say its space; LPS is assumed (SPACE=LPS or SPACE=RAS in the file says it)");
  if (frame != "RAS") return false;
  points.leftCols<2>() *= -1;
  frame = "LPS";
  return true;
}

void checkUnits(const Points& points, const std::string& name, std::vector<std::string>& warnings) {
  if (const double largest = points.cwiseAbs().maxCoeff(); largest > kAbsurdMm)
    throw InputError(name + " has a coordinate of " + numberText(largest) +
                     " mm, beyond 1e6 mm; it is damaged or in other units, export it again in mm");
  if (points.rows() < 2) return;
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  const std::string size = name + " is " + numberText(static_cast<float>(extent)) + " units wide: ";
  if (extent < kMetresBelow)
    warnings.push_back(size + "it looks like metres, not mm; scale it by 1000 if so");
  if (extent > kMicrometresAbove)
    warnings.push_back(size + "it looks like micrometres, not mm; scale it by 0.001 if so");
}

}  // namespace falciform
